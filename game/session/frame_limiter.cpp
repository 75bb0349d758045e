#include "game/session/frame_limiter.h"

#include <algorithm>

namespace gw {

// Whether showing a picture does wait.
bool FrameLimiter::trusted(double now_s, double passed_s) {
  if (now_s < doubtUntil_s_) return false;
  const double period_s = 1 / (rate_ > 0 ? rate_ : kFastRate);
  quick_ = passed_s < kQuick * period_s ? quick_ + 1 : 0;
  if (quick_ < kQuickFrames) return true;
  quick_ = 0;
  doubtUntil_s_ = now_s + kDoubt_s;
  return false;
}

double FrameLimiter::wait_s(double now_s, bool waits, bool hidden) {
  const double passed_s = now_s - last_s_;
  last_s_ = now_s;
  if (!hidden && waits && trusted(now_s, passed_s)) {
    due_s_ = now_s;
    return 0;
  }
  const double unknown = waits ? kFastRate : kUsualRate;
  due_s_ += hidden ? kHiddenPeriod_s : 1 / (rate_ > 0 ? rate_ : unknown);
  due_s_ = std::max(due_s_, now_s);  // late: the next frame is due from here
  return due_s_ - now_s;
}

}  // namespace gw
