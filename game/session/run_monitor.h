// Watches one run's reports and remembers what screens show of the recent past: data per second, what
// hit the ship last and what it cost.
#pragma once

#include <array>
#include <cstdint>

#include "game/sim/simulation.h"

namespace gw {

class RunMonitor {
 public:
  static constexpr uint32_t kContactShown_ticks = 2 * kTicksPerSecond;

  struct Contact {
    uint32_t type = kTypeNone;
    uint32_t cost_us = 0;
    uint32_t tick = 0;
    uint32_t before_us = 0, after_us = 0;  // frame time
  };

  void add(const TickReport& report);
  void reset() { *this = {}; }

  const TickReport& last() const { return last_; }
  // Enemies processed and bits taken in the last 60 ticks.
  uint32_t dataPerSecond() const { return dataPerSecond_; }
  const Contact& lastContact() const { return contact_; }
  // 1 at a contact, 0 from kContactShown_ticks later; 0 when there was none.
  float contactFreshness() const;
  // The frame time that the meter's trail still shows: follows the real one slowly after a loss.
  float trailingFrameTime_us() const { return trailing_us_; }

 private:
  TickReport last_{};
  Contact contact_{};
  std::array<uint32_t, kTicksPerSecond> data_{};  // per tick
  uint32_t dataPerSecond_ = 0;
  float trailing_us_ = 0;
};

}  // namespace gw
