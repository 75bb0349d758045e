// How long a frame waits before the next one. Pure: times go in and a wait comes out, so that it is tested without a
// screen.
//
// A window that waits for its screen needs no limit; but drivers say that they wait and do not, always or while the
// window is hidden, and a game at full speed is then nothing but heat.
#pragma once

#include <cstdint>

namespace gw {

class FrameLimiter {
 public:
  // Of a hidden window, which draws nothing. Three ticks each: FixedTimestep::kMostTicksPerFrame lets no tick be lost.
  static constexpr double kHiddenPeriod_s = 1.0 / 20;

  // Frames a second of the screen; 0 or less: not known.
  void setScreenRate(double perSecond) { rate_ = perSecond; }

  // At the end of a frame: for how long to wait. waits: showing it has waited, or claims to have.
  double wait_s(double now_s, bool waits, bool hidden);

 private:
  // A screen is doubted when this many frames in a row came in less than this share of its period: of one that waits
  // a few may, those that were queued behind a late one. After five seconds at our own pace it is trusted again.
  static constexpr uint32_t kQuickFrames = 8;
  static constexpr double kQuick = 0.8;
  static constexpr double kDoubt_s = 5;
  // An unknown screen: 60 where it does not wait; where it claims to, no slower than fast ones are.
  static constexpr double kUsualRate = 60, kFastRate = 240;

  bool trusted(double now_s, double passed_s);

  double rate_ = 0;
  double last_s_ = 0, due_s_ = 0, doubtUntil_s_ = 0;
  uint32_t quick_ = 0;  // in a row
};

}  // namespace gw
