// When the next tick is due. Pure: seconds go in, ticks and a share between two ticks come out, so that
// pacing is tested without a window and can never leak into the simulation.
#pragma once

#include <cstdint>

namespace gw {

class FixedTimestep {
 public:
  static constexpr uint32_t kMostTicksPerFrame = 5;

  // The time of a frame's start, in seconds of any steady clock. The first call only sets the clock.
  // Time for more than kMostTicksPerFrame ticks is dropped and counted: a machine that cannot keep up
  // plays slower instead of falling ever further behind.
  void frame(double now_s);

  // True, and one tick is taken, while ticks are due in this frame.
  bool due();

  // Whether ticks are left that this frame had no time for.
  bool behind() const;
  // Shows the last tick as it ended, and owes nothing: after a jump to it.
  void showLast();

  // Hit-stop: no tick for this long, and none caught up afterwards. Ticks that were due in this frame
  // are part of it.
  void withhold(double seconds);

  // Paused time does not pass at all.
  void pause() { paused_ = true; }
  void resume() { paused_ = false; }
  bool paused() const { return paused_; }

  // Times real time; 1 in play.
  void setSpeed(double speed) { speed_ = speed; }
  double speed() const { return speed_; }

  // How far this frame lies between the last two ticks, 0 to 1.
  float alpha() const;
  bool holding() const { return hold_s_ > 0; }
  uint64_t dropped() const { return dropped_; }

 private:
  double last_s_ = 0;
  bool started_ = false;
  bool paused_ = false;
  double speed_ = 1;
  double waiting_s_ = 0;  // time not yet turned into ticks
  double hold_s_ = 0;
  uint64_t dropped_ = 0;
};

}  // namespace gw
