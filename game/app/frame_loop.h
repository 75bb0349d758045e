// The loop of a program with a window: poll events, update the session, draw it, wait for the next frame. What is
// played, and which screens are shown, is the session's.
#pragma once

#include <SDL_events.h>

#include <vector>

#include "game/app/app_services.h"
#include "game/session/frame_limiter.h"

namespace gw {

// What the loop runs: playing (play_session.cpp) or watching a replay (replay_session.cpp).
class Session {
 public:
  virtual ~Session() = default;

  // Sees every event before keyboard, mouse and pads do; true: it is consumed.
  virtual bool handle(const SDL_Event&) { return false; }
  // One frame of screens and simulation. False: the session ends.
  virtual bool update() = 0;
  // Once per frame, after update(): whether it is drawn, or the time is better spent on more ticks.
  virtual bool drawsThisFrame() { return true; }

  virtual Run& run() = 0;
  virtual const Rules& rules() const = 0;
  virtual float brightness() const = 0;  // of the world
  virtual void drawScreens(Canvas& canvas) = 0;
};

class FrameLoop {
 public:
  FrameLoop(AppServices& services, Session& session);

  // Until the session ends, the window is closed or the program is interrupted.
  void run();

 private:
  bool poll();
  bool dispatchEvents();
  void draw();
  void pace(bool hidden);

  AppServices& services_;
  Session& session_;
  FrameLimiter limiter_;
  std::vector<SDL_Event> events_;  // of this frame
};

}  // namespace gw
