// gpuwars probe FILE: plays a recorded run as it is asked to, line by line, and says what it sees; the other end of
// 'gpuwars verify --reference'. docs/design/determinism.md has the purpose, game/desync/probe_protocol.h the
// protocol.
#include <iostream>

#include "game/cli/probe_options.h"
#include "game/desync/local_probe.h"
#include "game/desync/probe_protocol.h"
#include "game/replay/replay_reader.h"
#include "game/session/device_choice.h"

namespace gw {

ExitCode runVerb(const ProbeOptions& options) {
  const Replay replay = readReplay(options.file);
  SimulationConfig config = replayConfig(replay);
  setComputingOf(config, options, options.file.string());
  const DeviceChoice device = chooseDevice(options.device);
  LocalProbe probe([&] { return makeSimulation(device, config); }, replay.inputs);
  serveProbe(
      probe, [](std::string& line) { return bool(std::getline(std::cin, line)); },
      [](const std::string& line) { std::cout << line << std::endl; });
  return ExitCode::fine;
}

}  // namespace gw
