#include "game/cli/profile_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "game/cli/shared_options.h"
#include "host/cli/option_set.h"

namespace gw {
namespace {

using profile::SceneKind;

constexpr Choice<SceneKind> kScenes[] = {{"five-minutes", SceneKind::fiveMinutes},
                                         {"ramp", SceneKind::ramp},
                                         {"swarm", SceneKind::swarm},
                                         {"menu", SceneKind::menu}};
constexpr Choice<float> kGlows[] = {{"off", 0}, {"low", 0.5f}, {"high", 1}};
constexpr Choice<bool> kViews[] = {{"player", false}, {"world", true}};

constexpr uint32_t kLeastProfiledTicks = 60;

// Numbers of enemies, with commas.
std::vector<uint32_t> enemiesIn(const std::string& list) {
  std::vector<uint32_t> counts;
  for (size_t begin = 0; begin <= list.size();) {
    const size_t end = std::min(list.find(',', begin), list.size());
    const std::string word = list.substr(begin, end - begin);
    uint32_t count = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || stop != word.data() + word.size() || count < 1 || count > kMaxEnemies) {
      throw UsageError(fmt::format("'--enemies {}' is not valid; give whole numbers from 1 to {}, separated by commas",
                                   list, kMaxEnemies));
    }
    if (std::find(counts.begin(), counts.end(), count) != counts.end()) {
      throw UsageError(fmt::format("'--enemies {}' names {} twice; leave out one of the two", list, count));
    }
    counts.push_back(count);
    begin = end + 1;
  }
  return counts;
}

}  // namespace

void SceneOptions::declareScene(OptionSet& options) {
  options.text("--enemies", "the most enemies alive at once (8192); several with commas are measured one by one",
               "N,N,...", [this](const std::string& given) { enemiesList = enemiesIn(given); });
  options.text("--compare", "contenders, with commas: ngrid, grid, grid-hashed, brute, thesis (the broad phase)",
               "A,B,...", [this](const std::string& given) { compare = given; });
  options.integer("--runs", "of each contender, in turn (10)", 1, 1000, runs);
  options.integer("--ticks", "length of a run (all of the scene)", kLeastProfiledTicks, kMaxTicks, ticks);
  options.integer("--seconds", "the same in seconds of game time", 1, kMaxTicks / kTicksPerSecond, seconds);
  options.exclude("--ticks", "sets the length of a run, as does", "--seconds");
}

void LookOptions::declareLook(OptionSet& options) {
  options.flag("--headless", "draw without a window", headless);
  options.flag("--no-draw", "the simulation only", drawNothing);
  options.flag("--paced", "ticks in real time, as in play; else one with every frame", paced);
  options.choice("--view", kViews, "what is drawn: the player's view, or the whole world", "player", wholeWorld);
  options.choice("--effects", kOnOff, "particles, flashes, bending, shake", "on", effects);
  options.choice("--glow", kGlows, "how far light reaches outside a shape", "low", glow);
  options.exclude("--headless", "has no effect with", "--no-draw");
  options.exclude("--paced", "has no effect with", "--no-draw");
}

void ProfileOptions::declare(OptionSet& options) {
  declareComputing(options, GameSource::replay);
  options.choice("--scene", kScenes, "what is played", "five-minutes", scene);
  options.path("--replay", "play this replay instead of a scene", "FILE", replayPath);
  options.path("--out", "the folder of the report; created if missing", "DIR", outPath);
  options.require("--out");
  declareScene(options);
  declareLook(options);
  options.path("--trace", "write trace events for Perfetto or Chrome to FILE", "FILE", tracePath);
  options.path("--baseline", "compare with an earlier report.json; exit 1 when slower beyond the noise", "FILE",
               baselinePath);
  declareSize(options);
  options.exclude("--scene", "names what is played, as does", "--replay");
  options.exclude("--enemies", "has no effect with", "--replay");
}

void ProfileOptions::check() {
  checkComputing(GameSource::ownGame);
  const auto refuse = [](const char* sentence) { throw UsageError(sentence); };
  if (drawNothing && scene == SceneKind::menu) refuse("'--scene menu' is drawn; leave out '--no-draw'");
  if (!compare.empty() && broadPhase != BroadPhase::ngrid) {
    refuse("'--compare' names the broad phases; leave out '--broad-phase'");
  }
  if (sort && !compare.empty() && ("," + compare + ",").find(",ngrid,") == std::string::npos) {
    refuse("'--sort' is about the contender ngrid, which '--compare' does not name; leave out one of the two");
  }
  if (gather.value_or(Gather::exact) != Gather::exact) {
    refuse(
        "'gpuwars profile' plays exact games and measures an inexact gather beside them; use '--compare ngrid,thesis'");
  }
}

}  // namespace gw
