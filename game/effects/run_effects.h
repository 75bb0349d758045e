// The effects of one run: fed by its reports, looked at when a frame is drawn.
#pragma once

#include "game/effects/flash.h"
#include "game/effects/grid_bends.h"
#include "game/effects/score_pops.h"
#include "game/effects/shake.h"

namespace gw {

class RunEffects {
 public:
  // A report of the tick before, repeated after the end, changes nothing.
  void add(const TickReport& report);

  const GridBends& gridBends() const { return gridBends_; }
  const ScorePops& scorePops() const { return scorePops_; }
  const Shake& shake() const { return shake_; }
  const Flash& flash() const { return flash_; }

 private:
  uint32_t tick_ = 0;
  GridBends gridBends_;
  ScorePops scorePops_;
  Shake shake_;
  Flash flash_;
};

}  // namespace gw
