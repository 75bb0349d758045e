#include "game/cli/play_options.h"

#include "game/cli/shared_options.h"
#include "host/cli/option_set.h"

namespace gw {
namespace {

constexpr Choice<Mode> kModes[] = {
    {"arcade", Mode::arcade}, {"deadline", Mode::deadline}, {"swarm", Mode::swarm}, {"practice", Mode::practice}};
constexpr Choice<Autopilot> kAutopilots[] = {{"novice", Autopilot::novice}, {"expert", Autopilot::expert}};

}  // namespace

void GameOptions::declareGame(OptionSet& options) {
  options.choice("--mode", kModes, "the game mode", "arcade", mode);
  options.integer("--seed", "seed of the game; by default 1 when headless, else a new one each time", 0, UINT64_MAX,
                  seed);
  options.integer("--enemies", "the most enemies alive at once (8192)", 1, kMaxEnemies, enemies);
  options.choice("--autopilot", kAutopilots, "the bot that plays instead of you", "none", autopilot);
}

void PlayOptions::declare(OptionSet& options) {
  declareGame(options);
  options.integer("--ticks", "end after N ticks of 1/60 s", 1, kMaxTicks, ticks);
  options.flag("--headless", "no window, no waiting: as fast as possible", headless);
  options.path("--record", "write a replay to FILE", "FILE", recordPath);
  options.path("--hashes", "headless: write one line per tick to OUT ('-': stdout)", "OUT", hashesPath);
  options.path("--screenshot", "headless: write a picture of the last tick to FILE (PNG)", "FILE", screenshotPath,
               kDiagnostics);
  declareComputing(options, GameSource::ownGame);
  declareDesktop(options);
  options.exclude("--fullscreen", "has no effect with", "--headless");
  options.need("--headless", "--ticks");
  options.need("--hashes", "--headless");
  options.need("--screenshot", "--headless");
}

void PlayOptions::check() {
  checkComputing(GameSource::ownGame);
  if (!recordPath.empty() && recordPath == hashesPath) {
    throw UsageError("'--record' and '--hashes' name the same file; give each its own");
  }
}

}  // namespace gw
