#include "game/effects/shake.h"

#include <algorithm>
#include <cmath>

namespace gw {

namespace {

constexpr float kWearsOff_per_tick = 0.025f;  // full trauma is gone in 40 ticks
constexpr float kTurns_per_tick = 0.28f;      // new directions: 17 a second, under what a 60 Hz screen can show
constexpr uint32_t kHeavy = 100;              // value of a kill that shakes visibly

// -1 to 1, the same for the same step on every machine.
float noise(uint32_t step, uint32_t axis) {
  uint32_t x = step * 0x9E3779B9u ^ axis * 0x85EBCA6Bu;
  x ^= x >> 16;
  x *= 0x7FEB352Du;
  x ^= x >> 15;
  x *= 0x846CA68Bu;
  x ^= x >> 16;
  return float(x >> 8) / 8388608.0f - 1;
}

float smoothNoise(float t, uint32_t axis) {
  const float step = std::floor(t), share = t - step;
  const float a = noise(uint32_t(step), axis), b = noise(uint32_t(step) + 1, axis);
  return a + (b - a) * share * share * (3 - 2 * share);
}

}  // namespace

void Shake::add(const TickReport& report) {
  trauma_ = std::max(0.0f, trauma_ - kWearsOff_per_tick * float(report.tick - tick_));
  tick_ = report.tick;
  const auto heard = [&](SoundEvent event) { return report.sounds[uint32_t(event)][1] > 0; };
  if (heard(SoundEvent::over)) trauma_ += 1;
  if (report.contactType != kTypeNone) trauma_ += 0.85f;
  if (heard(SoundEvent::flush)) trauma_ += 0.6f;
  uint32_t heavy = 0;
  for (const Pop& pop : report.pops) {
    if (uint64_t(pop.points) * 10 >= uint64_t(kHeavy) * std::max(report.multiplierTenths, 10u)) ++heavy;
  }
  // Heavy ones alone never shake as a contact does, however many go at once.
  if (heavy > 0) trauma_ = std::max(trauma_, std::min(0.5f, trauma_ + 0.22f * float(heavy)));
  trauma_ = std::min(trauma_, 1.0f);
}

Shake::Offset Shake::at(const EffectTime& time, float scale) const {
  const float trauma = trauma_ - kWearsOff_per_tick * time.after_ticks(tick_);
  if (scale <= 0 || trauma <= 0) return {};
  const float reach_m = kMost_m * trauma * trauma * std::min(scale, 1.0f);
  // Twelve days of ticks before a float loses the step: far beyond any run.
  const float t = time.after_ticks(0) * kTurns_per_tick;
  return {smoothNoise(t, 1) * reach_m, smoothNoise(t, 2) * reach_m};
}

}  // namespace gw
