#include "game/profile/session/scene.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "game/profile/session/refill.h"
#include "game/replay/replay_reader.h"
#include "game/tables/tables.h"

namespace gw::profile {
namespace {

constexpr uint32_t kBotDecidesEvery_ticks = 4;  // the expert's; between them it repeats itself
constexpr uint16_t kBotButtons = kButtonFire | kButtonFlush;

struct Description {
  const char* name;
  const char* about;
  Mode mode;
  uint32_t ticks;
};
Description describe(SceneKind kind) {
  switch (kind) {
    case SceneKind::fiveMinutes:
      return {"five-minutes", "the expert bot among as many enemies as fit, every loss made good", Mode::practice,
              18000};
    case SceneKind::ramp:
      return {"ramp", "the expert bot while enemies come, from none to as many as fit", Mode::practice, 3600};
    case SceneKind::swarm:
      return {"swarm", "the expert bot against as many enemies as fit, all from the first tick", Mode::swarm, 3600};
    case SceneKind::menu:
      return {"menu", "the game that plays itself behind the title", Mode::arcade, 3600};
  }
  return {};
}

// Says what the bot would do. It sits in a game of its own, which is set to the state of the one that is recorded.
class Bot {
 public:
  explicit Bot(std::unique_ptr<Simulation> game) : game_(std::move(game)) {}

  InputRecord decide(Simulation& of) {
    game_->restore(of.snapshot());
    game_->tick({});
    InputRecord input = game_->report().input;
    input.buttons &= kBotButtons;
    return input;
  }

 private:
  std::unique_ptr<Simulation> game_;
};

class Recording {
 public:
  Recording(SceneKind kind, const SceneSize& size, const RuleTexts& rules, const MakeSimulation& make)
      : kind_(kind), enemies_(size.enemies), ticks_(size.ticks ? size.ticks : usualTicks(kind)) {
    const Description scene = describe(kind);
    scene_.name = scene.name;
    scene_.about = scene.about;
    scene_.title = kind == SceneKind::menu;
    Replay& replay = scene_.replay;
    replay.header.seed = size.seed;
    replay.header.mode = scene.mode;
    replay.header.enemies = size.enemies;
    replay.header.autopilot = Autopilot::expert;
    replay.header.options = fmt::format("profile --scene {} --enemies {}", scene.name, size.enemies);
    replay.rules = rules;
    SimulationConfig config = replayConfig(replay);
    types_ = config.rules.enemyTypeCount;
    const bool practice = scene.mode == Mode::practice;
    config.autopilot = practice ? Autopilot::none : Autopilot::expert;
    game_ = make(config);
    if (!practice) return;
    config.autopilot = Autopilot::expert;
    bot_.emplace(make(config));
  }

  Scene play(const std::function<bool(uint32_t)>& goOn) {
    Refill refill(types_, enemies_);
    TickReport report;
    InputRecord held;
    while (report.tick < ticks_ && report.over == 0 && (report.tick == 0 || goOn(report.tick))) {
      InputRecord input;
      if (bot_) {
        if (report.tick % kBotDecidesEvery_ticks == 0) held = bot_->decide(*game_);
        input = held;
        input.buttons |= refill.buttons(report.enemies, wanted(report.tick + 1), kind_ == SceneKind::ramp);
      }
      game_->tick(input);
      report = game_->report();
      keep(report);
    }
    scene_.replay.result = {report.score, report.kills, report.frameTime_us, report.over != 0};
    return std::move(scene_);
  }

 private:
  uint32_t wanted(uint32_t tick) const {
    return kind_ == SceneKind::ramp ? uint32_t(uint64_t(enemies_) * tick / ticks_) : enemies_;
  }

  void keep(const TickReport& report) {
    Replay& replay = scene_.replay;
    replay.inputs.push_back(report.input);
    replay.hashes.push_back(report.hash);
    if (report.tick % kFieldHashesEvery_ticks != 0) return;
    std::copy(std::begin(report.fieldHashes), std::end(report.fieldHashes), replay.fieldHashes.emplace_back().begin());
  }

  SceneKind kind_;
  uint32_t enemies_, ticks_, types_ = 1;
  Scene scene_;
  std::unique_ptr<Simulation> game_;
  std::optional<Bot> bot_;  // practice: its own input is mixed with the refilling
};

}  // namespace

const char* nameOf(SceneKind kind) {
  return describe(kind).name;
}
uint32_t usualTicks(SceneKind kind) {
  return describe(kind).ticks;
}

Scene recordScene(SceneKind kind, const SceneSize& size, const RuleTexts& rules, const MakeSimulation& make,
                  const std::function<bool(uint32_t)>& goOn) {
  return Recording(kind, size, rules, make).play(goOn);
}

Scene readFiveMinutes(const std::filesystem::path& assets) {
  const Description scene = describe(SceneKind::fiveMinutes);
  return {scene.name, scene.about, readReplay(assets / "scenes/five_minutes.gwr")};
}

Scene readScene(const std::filesystem::path& file) {
  return {file.filename().string(), fmt::format("the replay {}", file.filename().string()), readReplay(file)};
}

void cutTo(Scene& scene, uint32_t ticks) {
  Replay& replay = scene.replay;
  if (ticks == 0 || ticks >= replay.ticks()) return;
  replay.inputs.resize(ticks);
  replay.hashes.resize(ticks);
  replay.fieldHashes.resize(std::min<size_t>(replay.fieldHashes.size(), ticks / kFieldHashesEvery_ticks));
  replay.whole = false;  // how it ended is not known
}

}  // namespace gw::profile
