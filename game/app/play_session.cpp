// gpuwars [play]: title, runs and the screens between them, in a window.
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "game/app/frame_loop.h"
#include "game/app/player_settings.h"
#include "game/app/practice_controls.h"
#include "game/app/screen_flow.h"
#include "game/app/window_sessions.h"
#include "game/session/run_factory.h"
#include "game/settings/settings_menu.h"
#include "game/ui/crosshair.h"
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

class PlaySession : public Session {
 public:
  PlaySession(const PlayOptions& options, RunFactory& factory, PlayerSettings& settings, AppServices& services)
      : options_(options), factory_(factory), settings_(settings), services_(services), mode_(options.mode) {
    sayWhy(factory_.device());
    // With a bot or a number of ticks the run starts at once, without the title.
    const bool atOnce = options.autopilot != Autopilot::none || options.ticks > 0;
    screen_ = atOnce ? Screen::play : Screen::title;
    atOnce ? startRun() : startAttract();
    services_.instruments.makeBy([this](const SimulationConfig& config) { return factory_.makeAgain(config); });
  }

  bool update() override;
  Run& run() override { return *run_; }
  const Rules& rules() const override { return factory_.rules(); }
  float brightness() const override { return screen_ == Screen::title ? 0.8f : 1.0f; }
  void drawScreens(Canvas& canvas) override;

  // Prints the result of the run, if there is one, and keeps its recording.
  void leaveRun();

 private:
  bool runTicks();
  FlowInput flowInput();
  void chooseMode(const MenuPresses& menu);
  bool botPlays() const { return options_.autopilot != Autopilot::none; }
  // A player is in practice mode; a bot spawns by itself.
  bool practising() const { return practice_ && !attract_ && !botPlays(); }
  bool changeSettings(const MenuPresses& presses);
  void changeScreen(Screen before);
  void drawRun(Canvas& canvas, const KeyHints& hints);
  void drawAim(Canvas& canvas) const;
  std::string banner();
  bool deviceFailed();
  void startRun();
  void startAttract();
  void keepBest();

  const PlayOptions& options_;
  RunFactory& factory_;
  PlayerSettings& settings_;
  AppServices& services_;
  Settings settingsBefore_;  // when the settings screen was opened
  std::unique_ptr<Run> run_;
  Screen screen_ = Screen::title;
  double shownSince_s_ = 0;
  double deviceFailedAt_s_ = 0;       // 0: it has not, in this run
  std::optional<SettingsMenu> menu_;  // on the settings screen
  bool padGone_ = false;              // shown by the pause screen
  bool attract_ = false;              // the bot's run behind the title
  Mode mode_;                         // chosen on the title, and of the run
  SessionBest best_;
  Best bestBefore_;
  std::unique_ptr<PracticeControls> practice_;  // in practice mode
};

// One frame of the screen flow and of the simulation; false when the player leaves.
bool PlaySession::update() {
  const Screen before = screen_;
  switch (advance(screen_, flowInput())) {
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
  if (practising()) practice_->update(screen_, services_.timestep, *run_, services_.pointerInWorld());
  services_.window.showCursor(screen_ != Screen::play);
  services_.window.keepPointer(screen_ == Screen::play && !botPlays() && settings_.now.video.keepPointer);
  services_.audio.update(sceneOf(screen_), float(services_.clock.frameTime_s()));

  const bool attracting = attract_ && (screen_ == Screen::title || screen_ == Screen::settings);
  if (attracting && run_->over()) startAttract();
  (screen_ == Screen::play || attracting) ? services_.timestep.resume() : services_.timestep.pause();
  return runTicks();
}

// The ticks that are due. False when the run has the length that --ticks asks for.
bool PlaySession::runTicks() {
  FixedTimestep& timestep = services_.timestep;
  while (!run_->over() && timestep.due()) {
    if (screen_ == Screen::play && options_.ticks > 0 && run_->last().tick >= options_.ticks) return false;
    InputRecord record;
    if (screen_ == Screen::play) {
      const TickReport& last = run_->last();
      record = services_.input.record({last.ship_x, last.ship_y}, services_.pointerInWorld());
      if (practising()) record.buttons |= practice_->takeButtons();
    }
    run_->tick(record);
    const TickReport& report = run_->last();
    services_.audio.hear(report, rules());
    const bool hit = report.contactType != kTypeNone && !run_->over();
    if (hit) timestep.withhold(rules().budget.hitStop_ms / 1000.0);
  }
  return true;
}

FlowInput PlaySession::flowInput() {
  PlayerInput& keys = services_.input;
  const MenuPresses menu = keys.menu(services_.clock.now_s());
  FlowInput input;
  // Enter and Escape keep their meaning in menus, independent of the bindings.
  const bool inMenu = screen_ != Screen::play;
  // In the pause of practice mode a click inspects an enemy, so only the confirm keys of menus continue.
  const bool inspecting = screen_ == Screen::pause && practising();
  input.confirm = (!inspecting && keys.pressed(Action::confirm)) || (inMenu && menu.confirm);
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
  input.shown_s = services_.clock.now_s() - shownSince_s_;
  padGone_ = (padGone_ || input.lostPad) && !keys.padInUse();
  if (screen_ == Screen::settings) input.settingsDone = changeSettings(menu);
  return input;
}

void PlaySession::chooseMode(const MenuPresses& menu) {
  PlayerInput& keys = services_.input;
  int by = menu.right - menu.left;
  // The keys that move the ship choose too, but a pad's cross, which is both, must not count twice.
  if (by == 0) by = int(keys.pressed(Action::moveRight)) - int(keys.pressed(Action::moveLeft));
  mode_ = modeBeside(mode_, by);
}

// One frame of the settings screen. True when the player leaves it.
bool PlaySession::changeSettings(const MenuPresses& presses) {
  PlayerInput& keys = services_.input;
  menu_->setFullscreen(services_.window.fullscreen());
  menu_->setMuted(services_.audio.mutedByPlayer());
  if (const std::optional<Control> control = keys.heard()) menu_->hear(*control);
  menu_->press(presses, services_.clock.now_s());
  if (menu_->waiting() && !keys.listening()) keys.listen();
  if (!menu_->waiting()) keys.stopListening();
  if (!(menu_->settings() == settings_.now)) services_.apply(settings_.now = menu_->settings());
  return menu_->done();
}

void PlaySession::changeScreen(Screen before) {
  shownSince_s_ = services_.clock.now_s();
  if (screen_ == Screen::play) {
    services_.input.beginPlay();
    padGone_ = false;
  }
  if (screen_ == Screen::settings) {
    settings_.now.video.fullscreen = services_.window.fullscreen();
    settings_.now.sound.muted = services_.audio.mutedByPlayer();
    settingsBefore_ = settings_.now;
    menu_.emplace(settings_.now);
  }
  if (before == Screen::settings) settings_.write(settingsBefore_);
}

void PlaySession::drawScreens(Canvas& canvas) {
  const double now_s = services_.clock.now_s(), shown_s = now_s - shownSince_s_;
  const bool pad = services_.input.padInUse();
  const KeyHints hints = keyHints(settings_.now.bindings, pad);
  switch (screen_) {
    case Screen::title:
      drawTitle(canvas, {shown_s, run_->simulation().deviceName(), options_.enemies, mode_,
                         bestText(mode_, best_.of(mode_)), hints});
      return;
    case Screen::settings:
      drawSettings(canvas, *menu_, {now_s, pad});
      return;
    case Screen::play:
      drawRun(canvas, hints);
      if (!botPlays()) drawAim(canvas);
      return;
    case Screen::pause:
      drawRun(canvas, hints);
      practising() ? practice_->drawPause(canvas, rules(), hints, padGone_, services_)
                   : drawPause(canvas, rules(), {padGone_, hints});
      return;
    case Screen::over:
      drawRun(canvas, hints);
      drawGameOver(canvas, run_->monitor(), rules(), {shown_s, bestBefore_, true, mode_, options_.enemies, hints});
      return;
  }
}

// What is shown over a run on every screen.
void PlaySession::drawRun(Canvas& canvas, const KeyHints& hints) {
  HudFrame hud;
  hud.realFps = services_.clock.perSecond();
  hud.droppedTicks = services_.timestep.dropped();
  hud.mode = mode_;
  hud.enemies = options_.enemies;
  hud.best = bestText(mode_, best_.of(mode_));
  hud.banner = banner();
  drawHud(canvas, run_->monitor(), rules(), hud);
  if (practising()) practice_->drawPanel(canvas, rules(), hints);
}

// What differs from the usual game.
std::string PlaySession::banner() {
  if (deviceFailed()) return "GPU FAILED: THE PROCESSOR PLAYS ON";
  std::string text;
  if (options_.autopilot == Autopilot::novice) text = "NOVICE AUTOPILOT";
  if (options_.autopilot == Autopilot::expert) text = "EXPERT AUTOPILOT";
  const std::string neighbours = neighboursText(options_.gather.value_or(Gather::exact), options_.sort);
  if (!neighbours.empty()) text += (text.empty() ? "" : "  ") + neighbours;
  return text;
}

void PlaySession::drawAim(Canvas& canvas) const {
  const PlayerInput& input = services_.input;
  if (!input.aimsByMouse()) return;
  const CanvasPoint at = services_.window.toCanvas(input.pointer_x_px(), input.pointer_y_px());
  drawCrosshair(canvas, at.x, at.y);
}

// For some seconds after the device failed: explains the late frame.
bool PlaySession::deviceFailed() {
  if (run_->simulation().dropped().empty()) {
    deviceFailedAt_s_ = 0;
  } else if (deviceFailedAt_s_ == 0) {
    deviceFailedAt_s_ = services_.clock.now_s();
  }
  return deviceFailedAt_s_ > 0 && services_.clock.now_s() - deviceFailedAt_s_ < kFailureShown_s;
}

void PlaySession::startRun() {
  leaveRun();
  run_.reset();  // frees its memory first: two simulations at once may not fit
  run_ = factory_.make(mode_, options_.seed ? *options_.seed : randomSeed(), options_.autopilot, true);
  attract_ = false;
  practice_.reset();
  if (mode_ == Mode::practice) practice_ = std::make_unique<PracticeControls>(factory_.rules().enemyTypeCount);
  services_.input.forgetPresses();
  services_.beginRun(*run_);
}

void PlaySession::startAttract() {
  leaveRun();
  run_.reset();
  run_ = factory_.make(Mode::arcade, randomSeed(), Autopilot::expert, false);
  attract_ = true;
  services_.beginRun(*run_);
}

void PlaySession::leaveRun() {
  if (!run_ || attract_ || run_->last().tick == 0) return;
  run_->finishRecording();
  const TickReport& report = run_->last();
  std::printf("score %s, survived %s, %s processed%s%s\n", withCommas(report.score).c_str(),
              minutesSeconds(report.tick).c_str(), withCommas(report.kills).c_str(),
              run_->recorded() ? ", recorded to " : "", run_->recorded() ? factory_.recordPath().c_str() : "");
  std::fflush(stdout);
  attract_ = true;  // printed once
}

void PlaySession::keepBest() {
  bestBefore_ = best_.of(mode_);
  best_.enter(mode_, run_->last());
}

}  // namespace

ExitCode playWindow(const PlayOptions& options) {
  catchInterrupts();  // before SDL, which would end the program without reporting the signal
  RunFactory factory(options);
  PlayerSettings settings(options);
  AppServices services(options, settings.now, factory.assets());
  PlaySession session(options, factory, settings, services);
  FrameLoop(services, session).run();
  session.leaveRun();
  return ExitCode::fine;
}

}  // namespace gw
