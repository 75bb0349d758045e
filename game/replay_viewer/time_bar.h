// The bar at the bottom of a replay: where in the run this is, how far moments reach, and a place to click.
#pragma once

#include <cstdint>
#include <optional>

#include "game/ui/canvas.h"

namespace gw {

struct TimeBarFrame {
  uint32_t tick = 0, ticks = 1;
  uint32_t reach = 0;                    // to here going is fast
  std::optional<uint32_t> wish{};        // being gone to
  float seekShare = 0;                   // how far on the way there
  std::optional<uint32_t> differs{};     // from here on it is another game
  std::optional<uint32_t> underMouse{};  // the tick there
};

void drawTimeBar(Canvas& canvas, const TimeBarFrame& frame);

// In canvas units: a pointer that is a little off still means the bar.
bool overTimeBar(float x, float y, float canvasWidth);
// Of any place, also beside the bar: whoever drags does not look at his hand.
uint32_t tickOnTimeBar(float x, float canvasWidth, uint32_t ticks);

}  // namespace gw
