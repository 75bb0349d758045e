#include "game/effects/run_effects.h"

namespace gw {

void RunEffects::add(const TickReport& report) {
  if (report.tick == tick_) return;
  tick_ = report.tick;
  gridBends_.add(report);
  scorePops_.add(report);
  shake_.add(report);
  flash_.add(report);
}

}  // namespace gw
