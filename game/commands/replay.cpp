// gpuwars replay FILE: watch a run. Every tick's hash is compared on the way.
#include <algorithm>
#include <cstdio>
#include <optional>

#include "game/asset_folder.h"
#include "game/commands/commands.h"
#include "game/commands/hash_file.h"
#include "game/commands/player_settings.h"
#include "game/device_choice.h"
#include "game/game_loop.h"
#include "game/practice.h"
#include "game/replay/replay_reader.h"
#include "game/ui/format.h"
#include "game/ui/game_over.h"
#include "game/ui/hud.h"
#include "game/ui/pause.h"
#include "game/ui/practice_panel.h"
#include "game/user_error.h"

namespace gw {

namespace {

class ReplaySession {
 public:
  explicit ReplaySession(const Options& options)
      : options_(options),
        replay_(readReplay(options.files.front(), SimulationVersions::current, Completeness::partial)),
        config_(replayConfig(replay_)),
        device_(chooseDevice(options.device)),
        settingsFile_(settingsFileOf(options)),
        settings_(readPlayerSettings(settingsFile_)),
        loop_(options, settings_) {
    setComputingOf(config_, options, options.files.front().string());
    config_.particles = true;
    run_.emplace(makeLastingSimulation(device_, config_), std::nullopt);
    loop_.prepare(findAssetFolder(options.assetsDir), run_->simulation().capacity());
    const uint32_t from = std::min(options.fromTick.value_or(0), replay_.ticks());
    while (run_->last().tick < from && !run_->over()) tick();
    loop_.startAfresh(*run_);
    loop_.pacer().setSpeed(options.speed);
  }

  ExitCode watch() {
    while (loop_.beginFrame() && step()) {
      loop_.endFrame(*run_, config_.rules, 1, [this](Canvas& canvas) { drawScreens(canvas); });
    }
    if (!differs_) return ExitCode::fine;
    throw UserError(ExitCode::desync, options_.files.front().string() + " differs from tick " +
                                          std::to_string(*differs_) + " on: find out more with 'gpuwars verify'.");
  }

 private:
  bool ended() const { return run_->last().tick >= replay_.ticks() || run_->over(); }

  bool step() {
    PlayerInput& keys = loop_.input();
    const MenuPresses menu = keys.menu(loop_.now_s());
    const bool leave = keys.pressed(Action::quit);
    const bool toggle = keys.pressed(Action::pause) || keys.pressed(Action::confirm) || menu.confirm || menu.escape;
    keys.forgetPresses();
    if (leave || (toggle && ended())) return false;
    TickPacer& pacer = loop_.pacer();
    if (toggle) pacer.paused() ? pacer.resume() : pacer.pause();
    loop_.updateSound(ended() ? Scene::over : pacer.paused() ? Scene::pause : Scene::play);
    while (!ended() && pacer.due()) {
      tick();
      loop_.audio().hear(run_->last(), config_.rules);
    }
    loop_.showCursor(pacer.paused() || ended());
    return true;
  }

  void tick() {
    const uint32_t next = run_->last().tick;
    if (const auto request = requestIn(replay_.inputs[next], config_.rules.enemyTypeCount)) asked_ = *request;
    run_->tick(replay_.inputs[next]);
    if (!differs_ && run_->last().hash != replay_.hashes[next]) differs_ = next + 1;
  }

  void drawScreens(Canvas& canvas) {
    HudFrame hud;
    hud.realFps = loop_.realFps();
    hud.mode = config_.mode;
    hud.enemies = config_.enemies;
    hud.banner = "REPLAY  " + minutesSeconds(run_->last().tick) + " / " + minutesSeconds(replay_.ticks());
    if (options_.speed != 1) hud.banner += "  x" + oneDecimal(options_.speed);
    const std::string neighbours = neighboursText(config_.gather, config_.sortInUse());
    if (!neighbours.empty()) hud.banner += "  " + neighbours;
    if (differs_) hud.banner += "  DIFFERS FROM TICK " + std::to_string(*differs_);
    drawHud(canvas, run_->monitor(), config_.rules, hud);
    if (config_.mode == Mode::practice && asked_) {
      drawPracticePanel(canvas, config_.rules, {.type = asked_->type, .count = asked_->count, .keysShown = false});
    }
    const KeyHints hints = keyHints(settings_.bindings, loop_.input().padInUse());
    if (ended()) {
      endedSince_s_ = endedSince_s_ == 0 ? loop_.now_s() : endedSince_s_;
      if (run_->over())
        drawGameOver(canvas, run_->monitor(), config_.rules,
                     {loop_.now_s() - endedSince_s_, {}, false, config_.mode, config_.enemies, hints});
    } else if (loop_.pacer().paused()) {
      drawPause(canvas, config_.rules, {.replay = true, .keys = hints});
    }
  }

  Options options_;
  Replay replay_;
  SimulationConfig config_;
  DeviceChoice device_;
  SettingsFile settingsFile_;
  Settings settings_;
  GameLoop loop_;
  std::optional<Run> run_;
  std::optional<uint32_t> differs_;
  std::optional<PracticeRequest> asked_;  // last, in practice
  double endedSince_s_ = 0;
};

}  // namespace

ExitCode watchReplay(const Options& options) {
  return ReplaySession(options).watch();
}

}  // namespace gw
