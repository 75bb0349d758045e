// replay_again IN OUT [options of gpuwars play: --assets DIR, --threads N]
// Plays the inputs of a replay, of whatever simulation version, by today's kernels and tables, and records what comes
// of them: to their end, or to the end of the run if that comes first. So a person's run outlives a change of the
// rules.
#include <cstdio>
#include <exception>

#include "game/cli/command_line.h"
#include "game/replay/replay_reader.h"
#include "game/session/run_factory.h"

namespace {

void playAgain(const gw::Replay& old, gw::PlayOptions options) {
  const gw::ReplayHeader& header = old.header;
  options.mode = header.mode;
  options.seed = header.seed;
  options.enemies = header.enemies;
  options.gather = header.gather;
  if (header.gather != gw::Gather::exact) options.sort = header.sort;
  options.text = header.options;
  gw::RunFactory factory(options);
  const std::unique_ptr<gw::Run> run = factory.make(header.mode, header.seed, gw::Autopilot::none, true);
  for (const gw::InputRecord& input : old.inputs) {
    run->tick(input);
    if (run->over()) break;
  }
  run->finishRecording();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "Usage: replay_again IN OUT [--assets DIR] [--threads N]\n");
    return 2;
  }
  std::vector<std::string> arguments = {"--headless", "--device", "cpu", "--ticks", "1", "--record", argv[2]};
  arguments.insert(arguments.end(), argv + 3, argv + argc);
  const gw::ParsedCommandLine parsed = gw::parseCommandLine(arguments);
  if (!parsed.run) {
    std::fprintf(stderr, "%s\n", parsed.error.c_str());
    return 2;
  }
  try {
    playAgain(gw::readReplay(argv[1], gw::SimulationVersions::any), std::get<gw::PlayOptions>(parsed.options));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
