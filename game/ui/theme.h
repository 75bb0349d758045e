// The few colours and sizes that all screens share.
#pragma once

#include <algorithm>

#include "render/camera.h"
#include "render/text_pass.h"

namespace gw::theme {

inline constexpr Rgba kText = rgbaOf(0xdff6ff);
inline constexpr Rgba kQuiet = rgbaOf(0x7fa6bd);   // labels
inline constexpr Rgba kAccent = rgbaOf(0x35e0ff);  // the ship's cyan
inline constexpr Rgba kGold = rgbaOf(0xffc247);    // multiplier
inline constexpr Rgba kGood = rgbaOf(0x5dffa5);
inline constexpr Rgba kDanger = rgbaOf(0xff4a5e);
inline constexpr Rgba kShade = rgbaOf(0x03060d);  // behind menus

inline constexpr float kMargin = 28;

constexpr Rgba faded(Rgba colour, float alpha) {
  return {colour.red, colour.green, colour.blue, colour.alpha * alpha};
}

constexpr Rgba mixed(Rgba a, Rgba b, float share) {
  const float t = std::clamp(share, 0.0f, 1.0f);
  return {a.red + (b.red - a.red) * t, a.green + (b.green - a.green) * t, a.blue + (b.blue - a.blue) * t,
          a.alpha + (b.alpha - a.alpha) * t};
}

inline TextStyle style(float size, Rgba colour, TextAlign align = TextAlign::left, float glow = 0.3f) {
  TextStyle result;
  result.size_px = size;
  result.colour = colour;
  result.align = align;
  result.glow = glow;
  return result;
}

}  // namespace gw::theme
