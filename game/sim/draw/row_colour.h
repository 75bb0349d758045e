// A colour for each row of a grid: rows that follow each other must not look alike.
#pragma once

#include <cstdint>

#include "gpu/exec/device.h"

namespace gw::GW_DEVICE {

// 0xRRGGBB, bright and coloured. From row to row the hue goes on by the golden section of the circle: neighbours are
// 138 degrees apart, and rows two apart 85.
//
//   hue in 1/1536 of the circle:   0 red .. 256 yellow .. 512 green .. 768 cyan .. 1024 blue .. 1280 magenta ..
GW_FN uint32_t rowColour(uint32_t row) {
  const uint32_t hue = row % 1536u * 949u % 1536u, sextant = hue / 256u, part = hue % 256u;
  const uint32_t low = 56u, high = 255u;
  const uint32_t between = low + (high - low) * (sextant % 2u == 0u ? part : 255u - part) / 255u;
  const uint32_t red = sextant == 0u || sextant == 5u ? high : sextant == 1u || sextant == 4u ? between : low;
  const uint32_t green = sextant == 1u || sextant == 2u ? high : sextant == 0u || sextant == 3u ? between : low;
  const uint32_t blue = sextant == 3u || sextant == 4u ? high : sextant == 2u || sextant == 5u ? between : low;
  return red << 16 | green << 8 | blue;
}

}  // namespace gw::GW_DEVICE
