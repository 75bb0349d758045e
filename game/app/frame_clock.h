// The times of the current and the previous frame, and the rate of the frames that were shown.
#pragma once

#include <cstdint>

namespace gw {

class FrameClock {
 public:
  // A frame starts, at this time of a steady clock.
  void begin(double now_s) {
    previous_s_ = now_s_ == 0 ? now_s : now_s_;
    now_s_ = now_s;
  }
  double now_s() const { return now_s_; }
  double previous_s() const { return previous_s_; }
  double frameTime_s() const { return now_s_ - previous_s_; }

  // The frame was shown.
  void count() {
    constexpr double kPeriod_s = 0.5, kStalled_s = 5;  // after a stall the mean would be of no use
    ++counted_;
    const double passed_s = now_s_ - countedSince_s_;
    if (passed_s < kPeriod_s) return;
    perSecond_ = passed_s < kStalled_s ? counted_ / passed_s : 0;
    countedSince_s_ = now_s_;
    counted_ = 0;
  }
  // Frames per second, averaged over half a second; 0: not known yet.
  double perSecond() const { return perSecond_; }

 private:
  double now_s_ = 0, previous_s_ = 0;
  double countedSince_s_ = 0, perSecond_ = 0;
  uint32_t counted_ = 0;
};

}  // namespace gw
