// What a frame shows: the part of the world in view. Metres, x right, y up.
#pragma once

namespace gw {

struct Camera {
  float centre_x = 0, centre_y = 0;
  float halfWidth_m = 35.6f, halfHeight_m = 20;  // their ratio must be that of the target, or circles become ellipses
};

// Linear colour. What drawing functions take; 1 is the brightest the screen shows.
struct Rgba {
  float red = 1, green = 1, blue = 1, alpha = 1;
};

// 0xRRGGBB, as the enemy tables write colours.
constexpr Rgba rgbaOf(unsigned hex, float alpha = 1) {
  return {float((hex >> 16) & 255u) / 255, float((hex >> 8) & 255u) / 255, float(hex & 255u) / 255, alpha};
}

}  // namespace gw
