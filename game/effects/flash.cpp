#include "game/effects/flash.h"

#include <algorithm>

namespace gw {

namespace {

constexpr float kContact_ticks = 30, kFlush_ticks = 18;  // until it is dark again
constexpr Rgba kContact = rgbaOf(0xFF2038, 0.48f), kFlush = rgbaOf(0x9FD8FF, 0.26f);

}  // namespace

void Flash::add(const TickReport& report) {
  const bool contact = report.contactType != kTypeNone;
  const bool flush = report.sounds[uint32_t(SoundEvent::flush)][1] > 0;
  if (!contact && !flush) return;
  if (kind_ != Kind::none && report.tick - tick_ < kApart_ticks) return;
  kind_ = contact ? Kind::contact : Kind::flush;
  tick_ = report.tick;
}

FlashLight Flash::at(const EffectTime& time, float scale) const {
  if (kind_ == Kind::none || scale <= 0) return {};
  const bool contact = kind_ == Kind::contact;
  const float left = 1 - time.after_ticks(tick_) / (contact ? kContact_ticks : kFlush_ticks);
  if (left <= 0) return {};
  FlashLight light{contact ? kContact : kFlush, contact};
  light.colour.alpha *= left * left * std::min(scale, 1.0f);
  return light;
}

}  // namespace gw
