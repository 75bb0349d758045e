// gpuwars replay FILE: watch a run. Every tick's hash is compared on the way.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "game/app/frame_loop.h"
#include "game/app/player_settings.h"
#include "game/app/window_sessions.h"
#include "game/replay_viewer/free_camera.h"
#include "game/replay_viewer/replay_viewer.h"
#include "game/replay_viewer/speeds.h"
#include "game/replay_viewer/time_bar.h"
#include "game/replay_viewer/viewer_help.h"
#include "game/replay_viewer/viewer_keys.h"
#include "game/session/device_choice.h"
#include "game/session/practice.h"
#include "game/session/replay_file.h"
#include "game/ui/game_over.h"
#include "game/ui/hud.h"
#include "game/ui/practice_panel.h"
#include "game/ui/tick_text.h"
#include "host/platform/asset_folder.h"
#include "host/platform/clock.h"
#include "host/platform/interrupt.h"
#include "host/platform/number_format.h"
#include "host/platform/user_error.h"

namespace gw {

namespace {

// How long a frame computes before events are polled again, and how long no frame is drawn while ticks or a seek take
// all the time.
constexpr double kWork_s = 0.04, kUndrawn_s = 0.12;

SimulationConfig prefetchConfig(SimulationConfig config) {
  config.threads = 1;
  config.particles = false;
  return config;
}

// The requests of practice mode, by tick.
std::vector<std::pair<uint32_t, PracticeRequest>> requestsOf(const Replay& replay, const Rules& rules) {
  std::vector<std::pair<uint32_t, PracticeRequest>> requests;
  for (uint32_t tick = 1; tick <= replay.ticks(); ++tick) {
    if (const auto request = requestIn(replay.inputs[tick - 1], rules.enemyTypeCount))
      requests.push_back({tick, *request});
  }
  return requests;
}

// What is watched, found before the window opens.
struct WatchedReplay {
  explicit WatchedReplay(const ReplayOptions& options)
      : options(options),
        replay(readWatched(options.file)),
        config(replayConfig(replay)),
        device(chooseDevice(options.device)) {}

  const ReplayOptions& options;
  Replay replay;
  SimulationConfig config;
  DeviceChoice device;
};

class ReplaySession : public Session {
 public:
  ReplaySession(WatchedReplay& watched, const Settings& settings, uint32_t fromTick, AppServices& services)
      : options_(watched.options),
        replay_(watched.replay),
        config_(watched.config),
        device_(watched.device),
        settings_(settings),
        services_(services),
        speed_(options_.speed) {
    setComputingOf(config_, options_, options_.file.string());
    config_.particles = true;
    if (config_.mode == Mode::practice) requests_ = requestsOf(replay_, config_.rules);
    sayWhy(device_);
    // Every device computes the same bits: prefetching leaves the GPU to the picture.
    viewer_.emplace(replay_, makeLastingSimulation(device_, config_),
                    [config = prefetchConfig(config_)] { return cpu::makeSimulation(config); });
    Simulation& simulation = viewer_->run().simulation();
    camera_.emplace(simulation.worldWidth_m(), simulation.worldHeight_m());
    services_.instruments.makeBy(
        [this](const SimulationConfig& config) { return makeLastingSimulation(device_, config); });
    services_.beginRun(viewer_->run());
    services_.timestep.setSpeed(speed_);
    viewer_->seek(fromTick);
  }

  bool handle(const SDL_Event& event) override { return keys_.handle(event); }
  bool update() override;
  bool drawsThisFrame() override;
  Run& run() override { return viewer_->run(); }
  const Rules& rules() const override { return config_.rules; }
  float brightness() const override { return viewer_->seeking() ? 0.5f : 1.0f; }
  void drawScreens(Canvas& canvas) override;

  // Prints where it was left. Throws UserError when a hash differed.
  void finish() const;

 private:
  bool ended() const { return viewer_->ended() && !viewer_->seeking(); }
  void togglePause();
  void changeSpeed(int steps);
  void moveInTime(const ViewerPresses& presses);
  void useTimeBar(const ViewerPresses& presses);
  void moveCamera(const ViewerPresses& presses);
  void advanceReplay();
  std::string banner() const;
  void drawResult(Canvas& canvas, const KeyHints& hints);
  void drawRequest(Canvas& canvas) const;
  TimeBarFrame timeBar() const;

  const ReplayOptions& options_;
  const Replay& replay_;
  SimulationConfig& config_;
  const DeviceChoice& device_;
  const Settings& settings_;
  AppServices& services_;
  double speed_;
  ViewerKeys keys_;
  std::vector<std::pair<uint32_t, PracticeRequest>> requests_;  // by tick
  std::optional<FreeCamera> camera_;
  bool wasFree_ = false, helpShown_ = false;
  bool onBar_ = false;  // the bar is being dragged on
  std::optional<uint32_t> underMouse_;
  double drawn_s_ = 0, updated_s_ = 0, endedSince_s_ = 0;
  std::optional<ReplayViewer> viewer_;
};

// Ticks come before pictures, but not without limit.
bool ReplaySession::drawsThisFrame() {
  const bool busy = viewer_->seeking() || (!ended() && services_.timestep.behind());
  if (busy && services_.clock.now_s() - drawn_s_ < kUndrawn_s) return false;
  drawn_s_ = services_.clock.now_s();
  return true;
}

bool ReplaySession::update() {
  PlayerInput& keys = services_.input;
  const MenuPresses menu = keys.menu(services_.clock.now_s());
  const bool leave = keys.pressed(Action::quit);
  const bool toggle = keys.pressed(Action::pause) || keys.pressed(Action::confirm) || menu.confirm || menu.escape;
  keys.forgetPresses();
  if (leave || ((toggle || options_.quitAtEnd) && ended())) return false;
  const ViewerPresses presses = keys_.take();
  if (toggle || presses.pauses % 2 != 0) togglePause();
  if (presses.helps % 2 != 0) helpShown_ = !helpShown_;
  changeSpeed(presses.speeds);
  moveInTime(presses);
  moveCamera(presses);
  advanceReplay();
  const bool heard = !services_.timestep.paused() && !viewer_->seeking() && isHeardAt(speed_);
  services_.audio.update(ended() ? Scene::over
                         : heard ? Scene::play
                                 : Scene::pause,
                         float(services_.clock.frameTime_s()));
  services_.window.showCursor(true);
  return true;
}

void ReplaySession::togglePause() {
  FixedTimestep& timestep = services_.timestep;
  if (ended()) viewer_->seek(0);  // plays it again
  if (timestep.paused() || ended()) {
    timestep.resume();
    helpShown_ = false;
  } else {
    timestep.pause();
    helpShown_ = true;
  }
}

void ReplaySession::changeSpeed(int steps) {
  for (; steps > 0; --steps) speed_ = faster(speed_);
  for (; steps < 0; ++steps) speed_ = slower(speed_);
  services_.timestep.setSpeed(speed_);
}

void ReplaySession::moveInTime(const ViewerPresses& presses) {
  if (presses.ticks != 0) {
    services_.timestep.pause();
    viewer_->seekBy(presses.ticks);
  }
  if (presses.seconds != 0) viewer_->seekBy(int64_t(presses.seconds) * kTicksPerSecond);
  if (presses.home) viewer_->seek(0);
  if (presses.end) viewer_->seek(viewer_->ticks());
  useTimeBar(presses);
  const bool moved = presses.ticks != 0 || presses.seconds != 0 || presses.home || presses.end || onBar_;
  if (moved) helpShown_ = false;  // it covers the picture
}

// A click or a drag on the time bar.
void ReplaySession::useTimeBar(const ViewerPresses& presses) {
  const GameWindow& window = services_.window;
  const float width = window.canvasWidth();
  const CanvasPoint pointer = window.toCanvas(keys_.pointer_x_px(), keys_.pointer_y_px());
  const bool overBar = keys_.pointerSeen() && overTimeBar(pointer.x, pointer.y, width);
  const uint32_t there = tickOnTimeBar(pointer.x, width, viewer_->ticks());
  const CanvasPoint click = window.toCanvas(presses.click_x, presses.click_y);
  if (presses.clicked) onBar_ = overTimeBar(click.x, click.y, width);
  if (onBar_ && (presses.clicked || presses.drag_x != 0) && viewer_->seekTarget() != there) viewer_->seek(there);
  if (!keys_.buttonHeld()) onBar_ = false;
  underMouse_ = overBar || onBar_ ? std::optional(there) : std::nullopt;
}

void ReplaySession::moveCamera(const ViewerPresses& presses) {
  constexpr float kPan_per_s = 0.9f;  // of the view's height
  const float passed_s = float(std::min(services_.clock.now_s() - updated_s_, 0.1));
  updated_s_ = services_.clock.now_s();
  const bool dragged = keys_.buttonHeld() && !onBar_ && (presses.drag_x != 0 || presses.drag_y != 0);
  if (presses.freeCamera && camera_->on()) {
    camera_->release();
  } else if (presses.freeCamera || dragged || presses.wheel != 0 || keys_.pan_x() != 0 || keys_.pan_y() != 0) {
    camera_->free(services_.view.cameraPlace());
  }
  if (presses.followShip) camera_->release();
  camera_->pan(float(keys_.pan_x()) * kPan_per_s * passed_s, float(keys_.pan_y()) * kPan_per_s * passed_s);
  const CanvasPoint drag = services_.window.toCanvas(presses.drag_x, presses.drag_y);
  if (dragged) camera_->pan(-drag.x / Canvas::kHeight, drag.y / Canvas::kHeight);
  if (presses.wheel != 0 && camera_->on()) {
    const CanvasPoint at = services_.window.toCanvas(keys_.pointer_x_px(), keys_.pointer_y_px());
    const CameraPlace& place = *camera_->place();
    camera_->zoom(float(presses.wheel),
                  place.x + (at.x - services_.window.canvasWidth() / 2) / Canvas::kHeight * place.height_m,
                  place.y - (at.y / Canvas::kHeight - 0.5f) * place.height_m);
  }
  const bool followed = !camera_->on() && wasFree_;
  wasFree_ = camera_->on();
  if (followed) services_.view.cutCamera();
  services_.view.placeCamera(camera_->place());
}

// Towards the seek target, or plays on.
void ReplaySession::advanceReplay() {
  FixedTimestep& timestep = services_.timestep;
  if (viewer_->seeking()) {
    viewer_->continueSeek(kWork_s * 1000);
    timestep.showLast();
    services_.view.cutCamera();
    return;
  }
  const double until_s = now_s() + kWork_s;
  while (!ended() && timestep.behind() && now_s() < until_s) {
    timestep.due();
    viewer_->playOne();
    if (isHeardAt(speed_)) services_.audio.hear(viewer_->run().last(), config_.rules);
  }
}

std::string ReplaySession::banner() const {
  std::string text = "REPLAY  " + minutesSeconds(viewer_->tick()) + " / " + minutesSeconds(viewer_->ticks());
  if (!replay_.whole) text += "  PARTIAL";
  if (speed_ != 1) text += "  " + speedText(speed_);
  const std::string neighbours = neighboursText(config_.gather, config_.sortInUse());
  if (!neighbours.empty()) text += "  " + neighbours;
  if (viewer_->differsFrom()) text += "  DIFFERS FROM TICK " + std::to_string(*viewer_->differsFrom());
  return text;
}

void ReplaySession::drawScreens(Canvas& canvas) {
  const bool paused = services_.timestep.paused();
  HudFrame hud;
  hud.realFps = services_.clock.perSecond();
  hud.mode = config_.mode;
  hud.enemies = config_.enemies;
  hud.banner = banner();
  drawHud(canvas, viewer_->run().monitor(), config_.rules, hud);
  const KeyHints hints = keyHints(settings_.bindings, services_.input.padInUse());
  drawRequest(canvas);
  if (!ended() && paused) drawPausedTag(canvas, viewer_->tick());
  drawResult(canvas, hints);
  drawViewerHints(canvas, paused, hints, hud.banner);
  drawTimeBar(canvas, timeBar());
  if (helpShown_ && !ended()) drawViewerHelp(canvas, hints);
}

// At the end of a run that is over.
void ReplaySession::drawResult(Canvas& canvas, const KeyHints& hints) {
  if (!ended()) endedSince_s_ = 0;
  if (!ended() || !viewer_->run().over()) return;
  const double now_s = services_.clock.now_s();
  if (endedSince_s_ == 0) endedSince_s_ = now_s;
  drawGameOver(canvas, viewer_->run().monitor(), config_.rules,
               {now_s - endedSince_s_, {}, false, config_.mode, config_.enemies, hints});
}

TimeBarFrame ReplaySession::timeBar() const {
  TimeBarFrame bar;
  bar.tick = viewer_->tick();
  bar.ticks = viewer_->ticks();
  bar.cachedTo = viewer_->prefetched() ? viewer_->ticks() : viewer_->cachedTo();
  if (viewer_->seeking()) bar.seekTarget = viewer_->seekTarget();
  bar.seekProgress = viewer_->seekProgress();
  bar.differs = viewer_->differsFrom();
  bar.underMouse = underMouse_;
  return bar;
}

// The last request in practice mode.
void ReplaySession::drawRequest(Canvas& canvas) const {
  const auto after = std::upper_bound(requests_.begin(), requests_.end(), viewer_->tick(),
                                      [](uint32_t tick, const auto& request) { return tick < request.first; });
  if (after == requests_.begin()) return;
  const PracticeRequest& asked = std::prev(after)->second;
  drawPracticePanel(canvas, config_.rules, {.type = asked.type, .count = asked.count, .keysShown = false});
}

void ReplaySession::finish() const {
  const std::string file = options_.file.string();
  std::printf("%s: left at tick %u of %u, state hash %s\n", file.c_str(), viewer_->tick(), viewer_->ticks(),
              hexadecimal(viewer_->run().last().hash).c_str());
  const auto differs = viewer_->differsFrom();
  if (!differs) return;
  throw UserError(ExitCode::desync, file + " differs from tick " + std::to_string(*differs) +
                                        " on: find out more with 'gpuwars verify'.");
}

}  // namespace

ExitCode watchReplay(const ReplayOptions& options) {
  catchInterrupts();
  WatchedReplay watched(options);
  const PlayerSettings settings(options);
  const uint32_t fromTick = tickInside(options.file, "--from", options.fromTick, watched.replay);
  AppServices services(options, settings.now, findAssetFolder(options.assetsDir));
  ReplaySession session(watched, settings.now, fromTick, services);
  FrameLoop(services, session).run();
  session.finish();
  return ExitCode::fine;
}

}  // namespace gw
