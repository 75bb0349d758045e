// gpuwars probe FILE: plays a recorded run as it is asked to, line by line, and says what it sees; the other end of
// 'gpuwars verify --reference'. docs/design/determinism.md tells what for, game/desync/probe_protocol.h the messages.
#include <iostream>

#include "game/commands/commands.h"
#include "game/desync/local_probe.h"
#include "game/desync/probe_protocol.h"
#include "game/replay/replay_reader.h"
#include "game/session/device_choice.h"

namespace gw {

ExitCode answerAsProbe(const Options& options) {
  const Replay replay = readReplay(options.files.front());
  SimulationConfig config = replayConfig(replay);
  setComputingOf(config, options, options.files.front().string());
  const DeviceChoice device = chooseDevice(options.device);
  LocalProbe probe([&] { return makeSimulation(device, config); }, replay.inputs);
  serveProbe(
      probe, [](std::string& line) { return bool(std::getline(std::cin, line)); },
      [](const std::string& line) { std::cout << line << std::endl; });
  return ExitCode::fine;
}

}  // namespace gw
