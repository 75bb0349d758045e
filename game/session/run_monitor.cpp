#include "game/session/run_monitor.h"

namespace gw {

void RunMonitor::add(const TickReport& report) {
  if (report.tick == last_.tick) return;  // after the end ticks change nothing
  const auto gained = uint32_t((report.kills - last_.kills) + (report.bitsTaken - last_.bitsTaken));
  uint32_t& slot = data_[report.tick % data_.size()];
  dataPerSecond_ += gained - slot;
  slot = gained;

  if (report.contactType != kTypeNone) {
    contact_ = {report.contactType, report.contactCost_us, report.tick, last_.frameTime_us, report.frameTime_us};
  }
  const auto now_us = float(report.frameTime_us);
  const bool held = contact_.type != kTypeNone && report.tick - contact_.tick < kTicksPerSecond / 2;
  if (last_.tick == 0) {
    trailing_us_ = now_us;
  } else if (!held) {
    trailing_us_ += (now_us - trailing_us_) * 0.12f;
  }
  last_ = report;
}

float RunMonitor::contactFreshness() const {
  if (contact_.type == kTypeNone) return 0;
  const uint32_t age = last_.tick - contact_.tick;
  return age >= kContactShown_ticks ? 0.0f : 1.0f - float(age) / float(kContactShown_ticks);
}

}  // namespace gw
