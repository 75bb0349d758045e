// The bar at the bottom of a replay: the current tick, how far it is cached, and where to click for a seek.
#pragma once

#include <cstdint>
#include <optional>

#include "game/ui/canvas.h"

namespace gw {

struct TimeBarFrame {
  uint32_t tick = 0, ticks = 1;
  uint32_t cachedTo = 0;                 // seeking is fast up to here
  std::optional<uint32_t> seekTarget{};  // of the seek in progress
  float seekProgress = 0;                // 0 to 1
  std::optional<uint32_t> differs{};     // the first tick with another hash
  std::optional<uint32_t> underMouse{};  // the tick there
};

void drawTimeBar(Canvas& canvas, const TimeBarFrame& frame);

// In canvas units: a pointer that is a little off still means the bar.
bool overTimeBar(float x, float y, float canvasWidth);
// Also for positions beside the bar: a drag may leave it.
uint32_t tickOnTimeBar(float x, float canvasWidth, uint32_t ticks);

}  // namespace gw
