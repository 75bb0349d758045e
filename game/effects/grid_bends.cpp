#include "game/effects/grid_bends.h"

#include <algorithm>
#include <cmath>

namespace gw {

namespace {

constexpr float kWakeResponse = 0.12f;  // share of the gap closed per tick
constexpr float kWakeBehind_s = 0.10f;  // the wake trails the ship by what it flies in this time
constexpr float kFastShip_mps = 16, kWake_m = 0.7f, kWakeWidth_m = 4.5f;

float mixed(float a, float b, float share) {
  return a + (b - a) * std::clamp(share, 0.0f, 1.0f);
}

}  // namespace

void GridBends::add(const TickReport& report) {
  for (const Pop& pop : report.pops) {
    if (pop.points == 0) continue;
    // Value, not points: a late triangle rocks the boat no more than an early one.
    const float value = float(pop.points) * 10 / float(std::max(report.multiplierTenths, 10u));
    const float weight = std::clamp(std::sqrt(value / 150), 0.15f, 1.0f);
    start({pop.x, pop.y, report.tick, 18, 2.4f + 1.8f * weight, 0.4f + 1.2f * weight, 0.3f + 0.25f * weight});
  }
  if (report.contactType != kTypeNone) {
    start({report.ship_x, report.ship_y, report.tick, 34, 6, 2.7f, 0.8f});
  }
  if (report.sounds[uint32_t(SoundEvent::flush)][1] > 0) {
    start({report.flush_x, report.flush_y, report.tick, report.flushRadius_m / kTick_s, 5, 2.6f, 0.6f});
  }
  if (report.sounds[uint32_t(SoundEvent::over)][1] > 0) {
    start({report.ship_x, report.ship_y, report.tick, 26, 8, 4, 1.6f});
  }
  ship_x_ = report.ship_x;
  ship_y_ = report.ship_y;
  shipPrevious_x_ = report.shipPrevious_x;
  shipPrevious_y_ = report.shipPrevious_y;
  wakeBefore_x_ = wake_x_;
  wakeBefore_y_ = wake_y_;
  wake_x_ += ((ship_x_ - shipPrevious_x_) / kTick_s - wake_x_) * kWakeResponse;
  wake_y_ += ((ship_y_ - shipPrevious_y_) / kTick_s - wake_y_) * kWakeResponse;
}

void GridBends::start(const Ripple& ripple) {
  ripples_[next_] = ripple;
  next_ = (next_ + 1) % kRipples;
}

std::vector<GridBend> GridBends::at(const EffectTime& time) const {
  std::vector<GridBend> bends;
  for (const Ripple& ripple : ripples_) {
    const float age_s = time.after_s(ripple.tick);
    if (ripple.strength_m <= 0 || age_s >= ripple.life_s) continue;
    const float left = 1 - age_s / ripple.life_s;
    bends.push_back({ripple.x, ripple.y, ripple.speed_mps * age_s, ripple.width_m, ripple.strength_m * left * left});
  }
  const float velocity_x = mixed(wakeBefore_x_, wake_x_, time.since_ticks);
  const float velocity_y = mixed(wakeBefore_y_, wake_y_, time.since_ticks);
  const float share = std::min(std::hypot(velocity_x, velocity_y) / kFastShip_mps, 1.0f);
  const size_t room = kMaxGridBends - 1;
  const auto stronger = [](const GridBend& a, const GridBend& b) { return a.strength_m > b.strength_m; };
  std::stable_sort(bends.begin(), bends.end(), stronger);
  if (bends.size() > room) bends.resize(room);
  if (share > 0.02f) {
    const float x = mixed(shipPrevious_x_, ship_x_, time.since_ticks) - velocity_x * kWakeBehind_s;
    const float y = mixed(shipPrevious_y_, ship_y_, time.since_ticks) - velocity_y * kWakeBehind_s;
    bends.insert(bends.begin(), {x, y, 0, kWakeWidth_m, kWake_m * share});
  }
  return bends;
}

}  // namespace gw
