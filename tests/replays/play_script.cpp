// play_script NAME [options of gpuwars play, --record FILE among them]
// Plays headless with the inputs of a script, until --ticks or the end of the run, and records it as the game does.
#include <cstdio>
#include <exception>
#include <string>

#include "game/cli/command_line.h"
#include "game/session/run_factory.h"
#include "tests/replays/script.h"

namespace {

int play(const gw::Script& script, const gw::PlayOptions& options) {
  gw::RunFactory factory(options);
  const std::unique_ptr<gw::Run> run = factory.make(options.mode, options.seed.value_or(1), options.autopilot, true);
  while (!run->over() && run->last().tick < options.ticks) run->tick(script(run->last()));
  run->finishRecording();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  gw::Scripts scripts;
  gw::addExtremes(scripts);
  gw::addPads(scripts);
  gw::addKeys(scripts);
  const auto found = argc > 1 ? scripts.find(argv[1]) : scripts.end();
  if (found == scripts.end()) {
    std::string names;
    for (const auto& [name, make] : scripts) names += " " + name;
    std::fprintf(stderr, "There is no script '%s'; name one of these first:%s.\n", argc > 1 ? argv[1] : "",
                 names.c_str());
    return 2;
  }
  gw::ParsedCommandLine parsed = gw::parseCommandLine({argv + 2, argv + argc});
  auto* options = std::get_if<gw::PlayOptions>(&parsed.options);
  if (!parsed.run || options == nullptr || !options->headless || options->recordPath.empty() ||
      options->autopilot != gw::Autopilot::none) {
    std::fprintf(stderr, "%s\n",
                 parsed.error.empty() ? "A script needs --headless, --ticks and --record, and no --autopilot."
                                      : parsed.error.c_str());
    return 2;
  }
  options->text = "script " + found->first + " " + options->text;
  try {
    return play(found->second(), *options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
