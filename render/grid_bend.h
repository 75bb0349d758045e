// What bends the background's lines. Metres.
#pragma once

namespace gw {

// A ring of displacement round (x, y): lines are moved outwards by up to strength_m where they are radius_m
// away, by less to either side, by nothing from width_m on. Negative strengths pull inwards.
struct GridBend {
  float x = 0, y = 0;
  float radius_m = 0;  // 0: a dent with its steepest slope within width_m of the middle
  float width_m = 1;
  float strength_m = 0;
};

inline constexpr int kMaxGridBends = 16;  // as in grid.vert

}  // namespace gw
