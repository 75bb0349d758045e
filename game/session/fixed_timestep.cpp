#include "game/session/fixed_timestep.h"

#include <algorithm>
#include <cmath>

#include "game/sim/rules.h"

namespace gw {

namespace {
constexpr double kTick = 1.0 / kTicksPerSecond;
}

void FixedTimestep::frame(double now_s) {
  const double passed = started_ ? std::max(0.0, now_s - last_s_) : 0.0;
  started_ = true;
  last_s_ = now_s;
  if (paused_) return;
  const double held = std::min(hold_s_, passed);
  hold_s_ -= held;
  waiting_s_ += (passed - held) * speed_;
  // Faster than real time may need more ticks a frame than catching up may.
  const double most = std::ceil(kMostTicksPerFrame * std::max(1.0, speed_)) * kTick;
  if (waiting_s_ >= most + kTick) {
    const double surplus = std::floor((waiting_s_ - most) / kTick);
    dropped_ += uint64_t(surplus);
    waiting_s_ -= surplus * kTick;
  }
}

// A clock that sums sixtieths falls a rounding error short of a whole tick; that is still a tick.
bool FixedTimestep::behind() const {
  return !paused_ && waiting_s_ >= kTick - 1e-9;
}

void FixedTimestep::showLast() {
  waiting_s_ = kTick * (1 - 1e-6);
}

bool FixedTimestep::due() {
  if (!behind()) return false;
  waiting_s_ = std::max(0.0, waiting_s_ - kTick);
  return true;
}

void FixedTimestep::withhold(double seconds) {
  hold_s_ = std::max(hold_s_, seconds);
  const double spent = std::min(hold_s_, waiting_s_);
  hold_s_ -= spent;
  waiting_s_ -= spent;
}

float FixedTimestep::alpha() const {
  return float(std::clamp(waiting_s_ / kTick, 0.0, 1.0));
}

}  // namespace gw
