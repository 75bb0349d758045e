#include "game/effects/score_pops.h"

#include <algorithm>
#include <cmath>

namespace gw {

namespace {

constexpr float kRise_m = 1.6f;                        // in all, soon slower
constexpr float kSmall = 9, kLarge = 22;               // canvas units
constexpr float kFewPoints = 10, kManyPoints = 20000;  // between these sizes grow with the logarithm
constexpr float kGrowth = 0.35f, kGrowth_ticks = 8;    // a number that takes one in swells for a moment
constexpr float kFadesFrom = 0.55f;                    // share of its life

float sizeOf(uint64_t points) {
  const float share = std::log(float(points) / kFewPoints) / std::log(kManyPoints / kFewPoints);
  return kSmall + (kLarge - kSmall) * std::clamp(share, 0.0f, 1.0f);
}

}  // namespace

void ScorePops::add(const TickReport& report) {
  std::erase_if(numbers_, [&](const Number& n) { return report.tick - n.tick >= kLife_ticks; });
  for (const Pop& pop : report.pops) {
    if (pop.points == 0 || join(pop, report.tick)) continue;
    makeRoom(report.tick);
    numbers_.push_back({pop.x, pop.y, pop.points, report.tick, report.tick});
  }
}

// The nearest young number takes the points in, if one is near enough.
bool ScorePops::join(const Pop& pop, uint32_t tick) {
  Number* nearest = nullptr;
  float best_m = kMerges_m;
  for (Number& number : numbers_) {
    const float away_m = std::hypot(number.x - pop.x, number.y - pop.y);
    if (tick - number.tick >= kMerges_ticks || away_m > best_m) continue;
    nearest = &number;
    best_m = away_m;
  }
  if (!nearest) return false;
  nearest->points += pop.points;
  nearest->grownAt = tick;
  return true;
}

// The least goes: few points, and not much of its life left.
void ScorePops::makeRoom(uint32_t tick) {
  if (numbers_.size() < kMost) return;
  const auto worth = [&](const Number& n) { return double(n.points) * double(kLife_ticks - (tick - n.tick)); };
  numbers_.erase(std::min_element(numbers_.begin(), numbers_.end(),
                                  [&](const Number& a, const Number& b) { return worth(a) < worth(b); }));
}

std::vector<ScorePops::Shown> ScorePops::at(const EffectTime& time) const {
  std::vector<Shown> shown;
  for (const Number& number : numbers_) {
    const float age = time.after_ticks(number.tick) / float(kLife_ticks);
    if (age >= 1) continue;
    const float swollen = std::max(0.0f, 1 - time.after_ticks(number.grownAt) / kGrowth_ticks);
    const float opacity = std::min(1.0f, (1 - age) / (1 - kFadesFrom));
    shown.push_back({number.x, number.y + kRise_m * (1 - (1 - age) * (1 - age)), number.points,
                     sizeOf(number.points) * (1 + kGrowth * swollen * swollen), opacity});
  }
  return shown;
}

}  // namespace gw
