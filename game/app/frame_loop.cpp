#include "game/app/frame_loop.h"

#include <SDL.h>

#include <chrono>
#include <thread>

#include "host/input/frame_events.h"
#include "host/platform/clock.h"
#include "host/platform/interrupt.h"

namespace gw {

FrameLoop::FrameLoop(AppServices& services, Session& session) : services_(services), session_(session) {
  limiter_.setScreenRate(services_.window.context().screenRate());
}

void FrameLoop::run() {
  while (poll() && session_.update()) {
    if (!session_.drawsThisFrame()) continue;
    services_.instruments.work(session_.run(), services_.clock.now_s());
    const bool hidden = services_.window.context().hidden();
    hidden ? session_.run().simulation().park() : draw();
    pace(hidden);
  }
}

// False when the window was closed.
bool FrameLoop::dispatchEvents() {
  AppServices& s = services_;
  bool open = true;
  const uint32_t polled_ms = SDL_GetTicks();  // the clock of SDL's own time stamps
  takeEvents(events_);
  for (const SDL_Event& event : events_) {
    if (event.type == SDL_QUIT) open = false;
    // The window may be on another screen now.
    if (event.type == SDL_WINDOWEVENT) limiter_.setScreenRate(s.window.context().screenRate());
    if (s.instruments.handle(event) || session_.handle(event)) continue;
    s.pads.handle(event);
    s.input.handle(event);
  }
  s.input.endFrame(polled_ms);
  return open;
}

// Events, the keys that mean the same everywhere, and the time of the new frame.
bool FrameLoop::poll() {
  AppServices& s = services_;
  const bool open = dispatchEvents();
  if (s.input.pressed(Action::fullscreen)) s.window.setFullscreen(!s.window.fullscreen());
  if (s.input.pressed(Action::mute)) s.audio.setMuted(!s.audio.muted());
  s.clock.begin(now_s());
  s.window.checkFullscreen(s.clock.now_s());
  s.timestep.frame(s.clock.now_s());
  return open && !interrupted();
}

void FrameLoop::draw() {
  AppServices& s = services_;
  Run& run = session_.run();
  SdlContext& context = s.window.context();
  context.bindTarget();
  const RunViewFrame frame{context.size(), session_.brightness(), s.instruments.colouring()};
  s.view.draw(run, session_.rules(), s.clock, s.timestep, frame, [&](Canvas& canvas) {
    session_.drawScreens(canvas);
    s.instruments.drawNotice(canvas, s.clock.now_s());
  });
  s.instruments.drawOverlay(run.last(), session_.rules(), s.clock.perSecond(), s.window.cursorShown());
  context.swap();
}

void FrameLoop::pace(bool hidden) {
  SdlContext& context = services_.window.context();
  const double wait_s = limiter_.wait_s(now_s(), context.verticalSync(), hidden);
  if (wait_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
  services_.clock.count();
}

}  // namespace gw
