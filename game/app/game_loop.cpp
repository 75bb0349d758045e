#include "game/app/game_loop.h"

#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>
#include <utility>

#include "game/ui/theme.h"
#include "host/input/frame_events.h"
#include "host/platform/interrupt.h"
#include "host/platform/user_error.h"
#include "host/platform/window_display.h"

namespace gw {

namespace {

double clock_s() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

float aspectOf(PixelSize size) {
  return float(std::max(size.width, 1)) / float(std::max(size.height, 1));
}

}  // namespace

GameLoop::GameLoop(const Options& options, const Settings& settings)
    : effects_(settings.effects), sound_(settings.sound), mute_(options.mute) {
  catchInterrupts();  // Ctrl-C closes the window, so that recordings are kept
  chooseDisplay();
  WindowOptions window;
  window.size = {int(options.width_px), int(options.height_px)};
  window.fullscreen = options.fullscreen || settings.fullscreen;
  try {
    context_ = makeSdlContext(window);
  } catch (const std::runtime_error& error) {
    throw UserError(ExitCode::failedRun, error.what());
  }
  instruments_ = std::make_unique<Instruments>(*context_);
  pads_ = std::make_unique<PadDevices>();
  if (!pads_->problem().empty()) std::fprintf(stderr, "%s\n", pads_->problem().c_str());
  input_.setBindings(settings.bindings);
  input_.setDeadZones(settings.pad.moveDeadZone, settings.pad.aimDeadZone);
  limiter_.setScreenRate(context_->screenRate());
  if (window.fullscreen) fullscreen_.ask(true, clock_s());
}

GameLoop::~GameLoop() {
  view_.reset();  // their GL objects go before their context
  instruments_.reset();
}

void GameLoop::prepare(const std::filesystem::path& assets, uint32_t capacity) {
  view_ = std::make_unique<WorldView>(assets, capacity);
  audio_ = std::make_unique<Audio>(assets, sound_, mute_);
}

void GameLoop::apply(const Settings& settings) {
  input_.setBindings(settings.bindings);
  input_.setDeadZones(settings.pad.moveDeadZone, settings.pad.aimDeadZone);
  effects_ = settings.effects;
  if (settings.fullscreen != fullscreen()) switchFullscreen(settings.fullscreen);
  if (settings.sound.muted != sound_.muted) mute(settings.sound.muted);
  sound_ = settings.sound;
  audio_->setVolumes(sound_);
}

void GameLoop::mute(bool on) {
  audio_->setMuted(on);
  sound_.muted = on;
}

void GameLoop::switchFullscreen(bool on) {
  context_->setFullscreen(on);
  fullscreen_.ask(on, clock_s());
}

bool GameLoop::beginFrame() {
  const uint32_t looked_ms = SDL_GetTicks();
  takeEvents(events_);
  for (const SDL_Event& event : events_) {
    if (event.type == SDL_QUIT) closed_ = true;
    if (event.type == SDL_WINDOWEVENT) limiter_.setScreenRate(context_->screenRate());  // it may be on another screen
    if (instruments_->handle(event) || (listener_ && listener_(event))) continue;
    pads_->handle(event);
    input_.handle(event);
  }
  input_.endFrame(looked_ms);
  if (input_.pressed(Action::fullscreen)) switchFullscreen(!fullscreen());
  if (input_.pressed(Action::mute)) mute(!audio_->muted());
  last_s_ = now_s_;
  now_s_ = clock_s();
  if (last_s_ == 0) last_s_ = now_s_;
  if (fullscreen_.look(context_->fullscreen(), now_s_)) {
    std::fprintf(stderr,
                 "The window system did not switch full screen %s: it takes a window manager, or --width and "
                 "--height of the screen.\n",
                 fullscreen() ? "off" : "on");
  }
  pacer_.frame(now_s_);
  return !closed_ && !interrupted();
}

void GameLoop::runTicks(Run& run, const Rules& rules, const InputSource& input) {
  while (!run.over() && pacer_.due()) {
    InputRecord record;
    if (!input(record)) return;
    run.tick(record);
    audio_->hear(run.last(), rules);
    if (run.last().contactType != kTypeNone && !run.over()) pacer_.withhold(rules.budget.hitStop_ms / 1000.0);
  }
}

InputRecord GameLoop::playerInput(const Run& run) {
  return input_.record({run.last().ship_x, run.last().ship_y}, underPointer());
}

WorldPoint GameLoop::underPointer() const {
  WorldPoint place;
  int width = 1, height = 1;  // events count in the window's own units, which are not always pixels
  SDL_GetWindowSize(context_->window(), &width, &height);
  if (camera_) {
    camera_->toWorld(input_.pointer_x_px(), input_.pointer_y_px(), float(width), float(height), place.x, place.y);
  }
  return place;
}

CanvasPoint GameLoop::onCanvas(WorldPoint place) const {
  CanvasPoint point;
  const float width = Canvas::kHeight * aspectOf(context_->size());
  if (camera_) camera_->toPixels(place.x, place.y, width, Canvas::kHeight, point.x, point.y);
  return point;
}

CanvasPoint GameLoop::toCanvas(float x_px, float y_px) const {
  int width = 1, height = 1;
  SDL_GetWindowSize(context_->window(), &width, &height);
  const float scale = Canvas::kHeight / float(std::max(height, 1));
  return {x_px * scale, y_px * scale};
}

float GameLoop::canvasWidth() const {
  return Canvas::kHeight * aspectOf(context_->size());
}

CameraPlace GameLoop::cameraPlace() const {
  return camera_ ? CameraPlace{camera_->x(), camera_->y(), 2 * camera_->halfHeight_m()} : CameraPlace();
}

void GameLoop::moveCamera(const Run& run, float alpha, float aspect) {
  const FollowCamera::Target target = cameraTarget(run.last(), alpha);
  const bool jumped = std::exchange(jumped_, false);
  const double passed_s = pacer_.paused() ? 0 : now_s_ - (drawn_s_ == 0 ? last_s_ : drawn_s_);
  drawn_s_ = now_s_;
  if (place_) {
    camera_->place(*place_, aspect);
  } else if (jumped) {
    camera_->snap(target, aspect);
  } else {
    camera_->follow(target, aspect, float(passed_s * std::max(1.0, pacer_.speed())));  // a fast ship is not lost
  }
}

void GameLoop::endFrame(Run& run, const Rules& rules, float brightness, const WorldView::Screens& screens) {
  instruments_->work(run, now_s_);
  const bool hidden = context_->hidden();
  if (hidden) {
    run.simulation().park();
  } else {
    draw(run, rules, brightness, screens);
    context_->swap();
  }
  limitFrames(hidden);
  countFrame();
}

void GameLoop::draw(Run& run, const Rules& rules, float brightness, const WorldView::Screens& screens) {
  const PixelSize size = context_->size();
  const float alpha = pacer_.alpha();
  if (run.last().tick == 0 && !place_) {
    // Nothing has been simulated yet, so nobody knows where the ship is: the middle of the world.
    camera_->snap({run.simulation().worldWidth_m() / 2, run.simulation().worldHeight_m() / 2, 0, 0}, aspectOf(size));
  } else {
    moveCamera(run, alpha, aspectOf(size));
  }
  context_->bindTarget();
  if (!run.over()) overSince_s_ = 0;
  if (run.over() && overSince_s_ == 0) overSince_s_ = now_s_;
  WorldFrame frame{size, alpha, brightness};
  frame.afterEnd_ticks = run.over() ? float((now_s_ - overSince_s_) * kTicksPerSecond) : 0;
  frame.effects = effects_;
  if (pacer_.speed() > 1) frame.effects.flash = 0;  // they would come more often than is safe to look at
  frame.colouring = instruments_->colouring();
  view_->draw(run, rules, *camera_, frame, [&](Canvas& canvas) {
    screens(canvas);
    instruments_->drawNotice(canvas, now_s_);
  });
  instruments_->drawOverlay(run.last(), rules, realFps_, cursorShown_);
}

void GameLoop::updateSound(Scene scene) {
  audio_->update(scene, float(now_s_ - last_s_));
}

void GameLoop::startAfresh(Run& run) {
  camera_ = std::make_unique<FollowCamera>(run.simulation().worldWidth_m(), run.simulation().worldHeight_m());
  instruments_->forget();
  pacer_ = TickPacer();  // its clock starts with the next frame: loading is not playing
}

void GameLoop::showCursor(bool on) {
  if (on != cursorShown_) SDL_ShowCursor(on ? SDL_ENABLE : SDL_DISABLE);
  cursorShown_ = on;
}

void GameLoop::keepPointer(bool on) {
  if (on != pointerKept_) context_->keepPointer(on);
  pointerKept_ = on;
}

void GameLoop::drawCrosshair(Canvas& canvas) const {
  if (!input_.aimsByMouse()) return;
  int width = 1, height = 1;
  SDL_GetWindowSize(context_->window(), &width, &height);
  const float scale = Canvas::kHeight / float(std::max(height, 1));
  const float x = input_.pointer_x_px() * scale, y = input_.pointer_y_px() * scale;
  const Rgba colour = theme::faded(theme::kAccent, 0.9f);
  for (const float side : {-1.0f, 1.0f}) {
    canvas.line(x + side * 5, y, x + side * 13, y, 1.5f, colour);
    canvas.line(x, y + side * 5, x, y + side * 13, 1.5f, colour);
  }
  canvas.rectangle(x - 1, y - 1, 2, 2, colour);
}

void GameLoop::limitFrames(bool hidden) {
  const double wait_s = limiter_.wait_s(clock_s(), context_->verticalSync(), hidden);
  if (wait_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
}

void GameLoop::countFrame() {
  ++counted_;
  const double passed = now_s_ - countedSince_s_;
  if (passed < 0.5) return;
  realFps_ = passed < 5 ? counted_ / passed : 0;
  countedSince_s_ = now_s_;
  counted_ = 0;
}

}  // namespace gw
