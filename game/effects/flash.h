// Sudden light over the whole picture: a red edge at a contact, a blue-white brightening at the flush. Drawn
// behind everything that lives, so that it hides nothing.
//
// Safe for photosensitive players: WCAG 2.3.1 allows three flashes in any second. A flash begins at least
// kApart_ticks after the one before it, else it is left out: never more than three begin within a second.
// Code that plays ticks faster than 60 a second must not show flashes at all.
#pragma once

#include "game/effects/effect_time.h"
#include "game/sim/simulation.h"
#include "render/camera.h"

namespace gw {

struct FlashLight {
  Rgba colour{0, 0, 0, 0};  // alpha: how strong; 0 means that there is none
  bool edge = false;        // only along the edges of the picture
};

class Flash {
 public:
  static constexpr uint32_t kApart_ticks = 24;

  void add(const TickReport& report);

  // `scale` 0 to 1; 0 is none at all.
  FlashLight at(const EffectTime& time, float scale) const;

 private:
  enum class Kind { none, contact, flush };
  Kind kind_ = Kind::none;
  uint32_t tick_ = 0;  // when it began
};

}  // namespace gw
