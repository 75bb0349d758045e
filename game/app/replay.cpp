// gpuwars replay FILE: watch a run. Every tick's hash is compared on the way.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "game/app/game_loop.h"
#include "game/app/player_settings.h"
#include "game/commands/commands.h"
#include "game/commands/hash_file.h"
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
#include "host/platform/interrupt.h"
#include "host/platform/user_error.h"

namespace gw {

namespace {

// How long a frame computes before events are looked at again, and how long none is drawn when ticks or a seek take
// all there is.
constexpr double kWork_s = 0.04, kUndrawn_s = 0.12;

double wallClock_s() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

SimulationConfig scoutConfig(SimulationConfig config) {
  config.threads = 1;
  config.particles = false;
  return config;
}

// What practice asked for, and after which tick.
std::vector<std::pair<uint32_t, PracticeRequest>> requestsOf(const Replay& replay, const Rules& rules) {
  std::vector<std::pair<uint32_t, PracticeRequest>> requests;
  for (uint32_t tick = 1; tick <= replay.ticks(); ++tick) {
    if (const auto request = requestIn(replay.inputs[tick - 1], rules.enemyTypeCount))
      requests.push_back({tick, *request});
  }
  return requests;
}

class ReplaySession {
 public:
  explicit ReplaySession(const Options& options)
      : options_(options),
        replay_(readWatched(options)),
        config_(replayConfig(replay_)),
        device_(chooseDevice(options.device)),
        settingsFile_(settingsFileOf(options)),
        settings_(readPlayerSettings(settingsFile_)),
        from_(tickInside(options, "--from", options.fromTick.value_or(0), replay_)),
        speed_(options.speed),
        loop_(options, settings_) {
    setComputingOf(config_, options, options.files.front().string());
    config_.particles = true;
    if (config_.mode == Mode::practice) requests_ = requestsOf(replay_, config_.rules);
    sayWhy(device_);
    // Bit for bit the same game on any device: the scout leaves the GPU to the picture.
    viewer_.emplace(replay_, makeLastingSimulation(device_, config_),
                    [config = scoutConfig(config_)] { return cpu::makeSimulation(config); });
    Simulation& simulation = viewer_->run().simulation();
    camera_.emplace(simulation.worldWidth_m(), simulation.worldHeight_m());
    loop_.prepare(findAssetFolder(options.assetsDir), simulation.capacity());
    loop_.makeBy([this](const SimulationConfig& config) { return makeLastingSimulation(device_, config); });
    loop_.startAfresh(viewer_->run());
    loop_.listenFirst([this](const SDL_Event& event) { return keys_.handle(event); });
    loop_.pacer().setSpeed(speed_);
    viewer_->seek(from_);
  }

  ExitCode watch() {
    while (loop_.beginFrame() && step()) {
      if (tooBusyToDraw()) continue;
      drawn_s_ = loop_.now_s();
      loop_.endFrame(viewer_->run(), config_.rules, viewer_->seeking() ? 0.5f : 1.0f,
                     [this](Canvas& canvas) { drawScreens(canvas); });
    }
    std::printf("%s: left at tick %u of %u, state hash %s\n", options_.files.front().c_str(), viewer_->tick(),
                viewer_->ticks(), hexadecimal(viewer_->run().last().hash).c_str());
    const auto differs = viewer_->differsFrom();
    if (!differs) return ExitCode::fine;
    throw UserError(ExitCode::desync, options_.files.front().string() + " differs from tick " +
                                          std::to_string(*differs) + " on: find out more with 'gpuwars verify'.");
  }

 private:
  bool ended() const { return viewer_->ended() && !viewer_->seeking(); }

  // Ticks come before pictures, but not for ever.
  bool tooBusyToDraw() const {
    const bool busy = viewer_->seeking() || (!ended() && loop_.pacer().behind());
    return busy && loop_.now_s() - drawn_s_ < kUndrawn_s;
  }

  bool step() {
    PlayerInput& keys = loop_.input();
    const MenuPresses menu = keys.menu(loop_.now_s());
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
    playOn();
    const bool heard = !loop_.pacer().paused() && !viewer_->seeking() && isHeardAt(speed_);
    loop_.updateSound(ended() ? Scene::over : heard ? Scene::play : Scene::pause);
    loop_.showCursor(true);
    return true;
  }

  void togglePause() {
    TickPacer& pacer = loop_.pacer();
    if (ended()) viewer_->seek(0);  // once more from the start
    if (pacer.paused() || ended()) {
      pacer.resume();
      helpShown_ = false;
    } else {
      pacer.pause();
      helpShown_ = true;
    }
  }

  void changeSpeed(int steps) {
    for (; steps > 0; --steps) speed_ = faster(speed_);
    for (; steps < 0; ++steps) speed_ = slower(speed_);
    loop_.pacer().setSpeed(speed_);
  }

  void moveInTime(const ViewerPresses& presses) {
    if (presses.ticks != 0) {
      loop_.pacer().pause();
      viewer_->seekBy(presses.ticks);
    }
    if (presses.seconds != 0) viewer_->seekBy(int64_t(presses.seconds) * kTicksPerSecond);
    if (presses.home) viewer_->seek(0);
    if (presses.end) viewer_->seek(viewer_->ticks());
    const CanvasPoint pointer = loop_.toCanvas(keys_.pointer_x_px(), keys_.pointer_y_px());
    const bool overBar = keys_.pointerSeen() && overTimeBar(pointer.x, pointer.y, loop_.canvasWidth());
    const uint32_t there = tickOnTimeBar(pointer.x, loop_.canvasWidth(), viewer_->ticks());
    const CanvasPoint click = loop_.toCanvas(presses.click_x, presses.click_y);
    if (presses.clicked) onBar_ = overTimeBar(click.x, click.y, loop_.canvasWidth());
    if (onBar_ && (presses.clicked || presses.drag_x != 0) && viewer_->wish() != there) viewer_->seek(there);
    if (!keys_.buttonHeld()) onBar_ = false;
    underMouse_ = overBar || onBar_ ? std::optional(there) : std::nullopt;
    const bool moved = presses.ticks != 0 || presses.seconds != 0 || presses.home || presses.end || onBar_;
    if (moved) helpShown_ = false;  // whoever moves looks at the picture
  }

  void moveCamera(const ViewerPresses& presses) {
    constexpr float kPan_per_s = 0.9f;  // of the view's height
    const float passed_s = float(std::min(loop_.now_s() - stepped_s_, 0.1));
    stepped_s_ = loop_.now_s();
    const bool dragged = keys_.buttonHeld() && !onBar_ && (presses.drag_x != 0 || presses.drag_y != 0);
    if (presses.freeCamera && camera_->on()) {
      camera_->release();
    } else if (presses.freeCamera || dragged || presses.wheel != 0 || keys_.pan_x() != 0 || keys_.pan_y() != 0) {
      camera_->free(loop_.cameraPlace());
    }
    if (presses.followShip) camera_->release();
    camera_->pan(float(keys_.pan_x()) * kPan_per_s * passed_s, float(keys_.pan_y()) * kPan_per_s * passed_s);
    const CanvasPoint drag = loop_.toCanvas(presses.drag_x, presses.drag_y);
    if (dragged) camera_->pan(-drag.x / Canvas::kHeight, drag.y / Canvas::kHeight);
    if (presses.wheel != 0 && camera_->on()) {
      const CanvasPoint at = loop_.toCanvas(keys_.pointer_x_px(), keys_.pointer_y_px());
      const CameraPlace& place = *camera_->place();
      camera_->zoom(float(presses.wheel), place.x + (at.x - loop_.canvasWidth() / 2) / Canvas::kHeight * place.height_m,
                    place.y - (at.y / Canvas::kHeight - 0.5f) * place.height_m);
    }
    const bool followed = !camera_->on() && wasFree_;
    wasFree_ = camera_->on();
    if (followed) loop_.jump();
    loop_.look(camera_->place());
  }

  // Towards the tick that is wished for, or on with the play.
  void playOn() {
    TickPacer& pacer = loop_.pacer();
    if (viewer_->seeking()) {
      viewer_->work(kWork_s * 1000);
      pacer.showLast();
      loop_.jump();
      return;
    }
    const double until_s = wallClock_s() + kWork_s;
    while (!ended() && pacer.behind() && wallClock_s() < until_s) {
      pacer.due();
      viewer_->playOne();
      if (isHeardAt(speed_)) loop_.audio().hear(viewer_->run().last(), config_.rules);
    }
  }

  std::string banner() const {
    std::string text = "REPLAY  " + minutesSeconds(viewer_->tick()) + " / " + minutesSeconds(viewer_->ticks());
    if (!replay_.whole) text += "  PARTIAL";
    if (speed_ != 1) text += "  " + speedText(speed_);
    const std::string neighbours = neighboursText(config_.gather, config_.sortInUse());
    if (!neighbours.empty()) text += "  " + neighbours;
    if (viewer_->differsFrom()) text += "  DIFFERS FROM TICK " + std::to_string(*viewer_->differsFrom());
    return text;
  }

  void drawScreens(Canvas& canvas) {
    const Run& run = viewer_->run();
    const bool paused = loop_.pacer().paused();
    HudFrame hud;
    hud.realFps = loop_.realFps();
    hud.mode = config_.mode;
    hud.enemies = config_.enemies;
    hud.banner = banner();
    drawHud(canvas, run.monitor(), config_.rules, hud);
    const KeyHints hints = keyHints(settings_.bindings, loop_.input().padInUse());
    drawAsked(canvas);
    if (!ended()) {
      endedSince_s_ = 0;
      if (paused) drawPausedTag(canvas, viewer_->tick());
    } else if (run.over()) {
      endedSince_s_ = endedSince_s_ == 0 ? loop_.now_s() : endedSince_s_;
      drawGameOver(canvas, run.monitor(), config_.rules,
                   {loop_.now_s() - endedSince_s_, {}, false, config_.mode, config_.enemies, hints});
    }
    drawViewerHints(canvas, paused, hints, hud.banner);
    TimeBarFrame bar;
    bar.tick = viewer_->tick();
    bar.ticks = viewer_->ticks();
    bar.reach = viewer_->scouted() ? viewer_->ticks() : viewer_->reach();
    if (viewer_->seeking()) bar.wish = viewer_->wish();
    bar.seekShare = viewer_->seekShare();
    bar.differs = viewer_->differsFrom();
    bar.underMouse = underMouse_;
    drawTimeBar(canvas, bar);
    if (helpShown_ && !ended()) drawViewerHelp(canvas, hints);
  }

  // What was asked for last, in practice.
  void drawAsked(Canvas& canvas) const {
    const auto after = std::upper_bound(requests_.begin(), requests_.end(), viewer_->tick(),
                                        [](uint32_t tick, const auto& request) { return tick < request.first; });
    if (after == requests_.begin()) return;
    const PracticeRequest& asked = std::prev(after)->second;
    drawPracticePanel(canvas, config_.rules, {.type = asked.type, .count = asked.count, .keysShown = false});
  }

  Options options_;
  Replay replay_;
  SimulationConfig config_;
  DeviceChoice device_;
  SettingsFile settingsFile_;
  Settings settings_;
  uint32_t from_;
  double speed_;
  GameLoop loop_;
  ViewerKeys keys_;
  std::vector<std::pair<uint32_t, PracticeRequest>> requests_;  // by tick
  std::optional<FreeCamera> camera_;
  bool wasFree_ = false, helpShown_ = false;
  bool onBar_ = false;  // the bar is being dragged on
  std::optional<uint32_t> underMouse_;
  double drawn_s_ = 0, stepped_s_ = 0, endedSince_s_ = 0;
  std::optional<ReplayViewer> viewer_;
};

}  // namespace

ExitCode watchReplay(const Options& options) {
  catchInterrupts();
  return ReplaySession(options).watch();
}

}  // namespace gw
