// gpuwars [play]: title, runs and what lies between them, in a window.
#include <cstdio>
#include <memory>
#include <optional>

#include "game/app/game_loop.h"
#include "game/app/played_practice.h"
#include "game/app/player_settings.h"
#include "game/app/screen_flow.h"
#include "game/commands/commands.h"
#include "game/session/run_factory.h"
#include "game/settings/settings_menu.h"
#include "game/ui/game_over.h"
#include "game/ui/hud.h"
#include "game/ui/mode_choice.h"
#include "game/ui/pause.h"
#include "game/ui/session_best.h"
#include "game/ui/settings_screen.h"
#include "game/ui/tick_text.h"
#include "game/ui/title.h"
#include "host/platform/interrupt.h"
#include "host/platform/number_format.h"

namespace gw {

namespace {

Scene sceneOf(Screen screen) {
  switch (screen) {
    case Screen::play:
      return Scene::play;
    case Screen::pause:
      return Scene::pause;
    case Screen::over:
      return Scene::over;
    default:
      return Scene::title;
  }
}

constexpr double kFailureShown_s = 10;

class PlaySession {
 public:
  explicit PlaySession(const Options& options)
      : options_(options),
        factory_(options),
        settingsFile_(settingsFileOf(options)),
        settings_(readPlayerSettings(settingsFile_)),
        loop_(options, settings_),
        mode_(options.mode) {
    sayWhy(factory_.device());
    // Whoever names a bot or a length wants to see that run, not the title.
    const bool atOnce = options.autopilot != Autopilot::none || options.ticks > 0;
    screen_ = atOnce ? Screen::play : Screen::title;
    atOnce ? startRun() : startAttract();
    loop_.prepare(factory_.assets(), run_->simulation().capacity());
    loop_.makeBy([this](const SimulationConfig& config) { return factory_.makeAgain(config); });
  }

  ExitCode play() {
    while (loop_.beginFrame()) {
      if (!step()) break;
      loop_.endFrame(*run_, factory_.rules(), screen_ == Screen::title ? 0.8f : 1.0f,
                     [this](Canvas& canvas) { drawScreens(canvas); });
    }
    leaveRun();
    return ExitCode::fine;
  }

 private:
  // One frame of the flow and of the simulation; false when the player leaves.
  bool step() {
    const Screen before = screen_;
    const FlowInput input = flowInput();
    switch (advance(screen_, input)) {
      case FlowEvent::startRun:
        startRun();
        break;
      case FlowEvent::leaveRun:
        startAttract();
        break;
      case FlowEvent::quitProgram:
        return false;
      case FlowEvent::none:
        break;
    }
    if (screen_ != before) changeScreen(before);
    if (before == Screen::play && screen_ == Screen::over) keepBest();
    if (practising()) practice_->step(screen_, loop_, *run_);
    loop_.showCursor(screen_ != Screen::play);
    loop_.keepPointer(screen_ == Screen::play && !botPlays() && settings_.keepPointer);
    loop_.updateSound(sceneOf(screen_));

    const bool attracting = attract_ && (screen_ == Screen::title || screen_ == Screen::settings);
    if (attracting && run_->over()) startAttract();
    (screen_ == Screen::play || attracting) ? loop_.pacer().resume() : loop_.pacer().pause();
    bool ended = false;
    loop_.runTicks(*run_, factory_.rules(), [&](InputRecord& record) {
      ended = screen_ == Screen::play && options_.ticks > 0 && run_->last().tick >= options_.ticks;
      if (screen_ == Screen::play) {
        record = loop_.playerInput(*run_);
        if (practising()) record.buttons |= practice_->takeButtons();
      }
      return !ended;
    });
    return !ended;
  }

  FlowInput flowInput() {
    PlayerInput& keys = loop_.input();
    const MenuPresses menu = keys.menu(loop_.now_s());
    FlowInput input;
    // Enter and Escape mean what they mean in menus, whatever is bound to them.
    const bool inMenu = screen_ != Screen::play;
    // In the pause of practice a click looks at an enemy, so only what confirms in every menu goes on.
    const bool looking = screen_ == Screen::pause && practising();
    input.confirm = (!looking && keys.pressed(Action::confirm)) || (inMenu && menu.confirm);
    input.retry = keys.pressed(Action::retry);
    input.pause = keys.pressed(Action::pause) || (inMenu && menu.escape);
    input.quit = keys.pressed(Action::quit);
    input.settings = keys.pressed(Action::settings);
    if (screen_ == Screen::title) chooseMode(menu);
    if (practising()) practice_->take(keys);
    keys.forgetPresses();
    input.lostFocus = keys.lostFocus();
    input.lostPad = keys.lostPad();
    input.botPlays = botPlays();
    input.endsAlone = botPlays() && options_.ticks > 0;
    input.inRun = !attract_;
    input.runOver = run_->over();
    input.shown_s = loop_.now_s() - shownSince_s_;
    padGone_ = (padGone_ || input.lostPad) && !keys.padInUse();
    if (screen_ == Screen::settings) input.settingsDone = changeSettings(menu);
    return input;
  }

  void chooseMode(const MenuPresses& menu) {
    PlayerInput& keys = loop_.input();
    int by = menu.right - menu.left;
    // A pad's cross is both; the keys that move the ship choose where the menu's own do not.
    if (by == 0) by = int(keys.pressed(Action::moveRight)) - int(keys.pressed(Action::moveLeft));
    mode_ = modeBeside(mode_, by);
  }

  bool botPlays() const { return options_.autopilot != Autopilot::none; }

  // A player who practises; a bot asks for its own.
  bool practising() const { return practice_ && !attract_ && !botPlays(); }

  // A frame of the settings screen. True when the player is done there.
  bool changeSettings(const MenuPresses& presses) {
    PlayerInput& keys = loop_.input();
    menu_->setFullscreen(loop_.fullscreen());
    menu_->setMuted(loop_.muted());
    if (const std::optional<Control> control = keys.heard()) menu_->hear(*control);
    menu_->press(presses, loop_.now_s());
    if (menu_->waiting() && !keys.listening()) keys.listen();
    if (!menu_->waiting()) keys.stopListening();
    if (!(menu_->settings() == settings_)) loop_.apply(settings_ = menu_->settings());
    return menu_->done();
  }

  void changeScreen(Screen before) {
    shownSince_s_ = loop_.now_s();
    if (screen_ == Screen::play) {
      loop_.input().beginPlay();
      padGone_ = false;
    }
    if (screen_ == Screen::settings) {
      settings_.fullscreen = loop_.fullscreen();
      settings_.sound.muted = loop_.muted();
      settingsBefore_ = settings_;
      menu_.emplace(settings_);
    }
    if (before == Screen::settings && !(settings_ == settingsBefore_)) {
      writePlayerSettings(settingsFile_, settingsBefore_, settings_);
    }
  }

  void drawScreens(Canvas& canvas) {
    const Rules& rules = factory_.rules();
    const double shown_s = loop_.now_s() - shownSince_s_;
    const bool pad = loop_.input().padInUse();
    const KeyHints hints = keyHints(settings_.bindings, pad);
    if (screen_ == Screen::title) {
      drawTitle(canvas, {shown_s, run_->simulation().deviceName(), options_.enemies, mode_,
                         bestText(mode_, best_.of(mode_)), hints});
      return;
    }
    if (screen_ == Screen::settings) {
      drawSettings(canvas, *menu_, {loop_.now_s(), pad});
      return;
    }
    HudFrame hud;
    hud.realFps = loop_.realFps();
    hud.droppedTicks = loop_.pacer().dropped();
    hud.mode = mode_;
    hud.enemies = options_.enemies;
    hud.best = bestText(mode_, best_.of(mode_));
    if (options_.autopilot == Autopilot::novice) hud.banner = "NOVICE AUTOPILOT";
    if (options_.autopilot == Autopilot::expert) hud.banner = "EXPERT AUTOPILOT";
    // Another game than the usual one: say so.
    const std::string neighbours = neighboursText(options_.gather.value_or(Gather::exact), options_.sort);
    if (!neighbours.empty()) hud.banner += (hud.banner.empty() ? "" : "  ") + neighbours;
    if (deviceFailed()) hud.banner = "GPU FAILED: THE PROCESSOR PLAYS ON";
    drawHud(canvas, run_->monitor(), rules, hud);
    if (practising()) practice_->drawPanel(canvas, rules, hints);
    if (screen_ == Screen::play && !botPlays()) loop_.drawCrosshair(canvas);
    if (screen_ == Screen::pause) {
      practising() ? practice_->drawPause(canvas, rules, hints, padGone_, loop_)
                   : drawPause(canvas, rules, {padGone_, hints});
    }
    if (screen_ == Screen::over) {
      drawGameOver(canvas, run_->monitor(), rules, {shown_s, bestBefore_, true, mode_, options_.enemies, hints});
    }
  }

  // For a while after the device failed: why a frame was late, and what plays now.
  bool deviceFailed() {
    if (run_->simulation().dropped().empty()) {
      deviceFailedAt_s_ = 0;
    } else if (deviceFailedAt_s_ == 0) {
      deviceFailedAt_s_ = loop_.now_s();
    }
    return deviceFailedAt_s_ > 0 && loop_.now_s() - deviceFailedAt_s_ < kFailureShown_s;
  }

  void startRun() {
    leaveRun();
    run_.reset();  // its memory first: two hordes at once may not fit
    run_ = factory_.make(mode_, options_.seed ? *options_.seed : randomSeed(), options_.autopilot, true);
    attract_ = false;
    practice_.reset();
    if (mode_ == Mode::practice) practice_ = std::make_unique<PlayedPractice>(factory_.rules().enemyTypeCount);
    loop_.input().forgetPresses();
    loop_.startAfresh(*run_);
  }

  void startAttract() {
    leaveRun();
    run_.reset();
    run_ = factory_.make(Mode::arcade, randomSeed(), Autopilot::expert, false);
    attract_ = true;
    loop_.startAfresh(*run_);
  }

  // Says what was reached and keeps the recording.
  void leaveRun() {
    if (!run_ || attract_ || run_->last().tick == 0) return;
    run_->finishRecording();
    const TickReport& report = run_->last();
    std::printf("score %s, survived %s, %s processed%s%s\n", withCommas(report.score).c_str(),
                minutesSeconds(report.tick).c_str(), withCommas(report.kills).c_str(),
                run_->recorded() ? ", recorded to " : "", run_->recorded() ? factory_.recordPath().c_str() : "");
    std::fflush(stdout);
    attract_ = true;  // said once
  }

  void keepBest() {
    bestBefore_ = best_.of(mode_);
    best_.enter(mode_, run_->last());
  }

  Options options_;
  RunFactory factory_;
  SettingsFile settingsFile_;
  Settings settings_, settingsBefore_;  // now, and when the settings screen was opened
  GameLoop loop_;
  std::unique_ptr<Run> run_;
  Screen screen_ = Screen::title;
  double shownSince_s_ = 0;
  double deviceFailedAt_s_ = 0;       // 0: it has not, in this run
  std::optional<SettingsMenu> menu_;  // on the settings screen
  bool padGone_ = false;              // what the pause must say
  bool attract_ = false;
  Mode mode_;  // chosen on the title, and of the run
  SessionBest best_;
  Best bestBefore_;
  std::unique_ptr<PlayedPractice> practice_;  // while the run is one
};

}  // namespace

ExitCode playWindow(const Options& options) {
  catchInterrupts();  // before SDL, which would end the game as well, but keep to itself why
  return PlaySession(options).play();
}

}  // namespace gw
