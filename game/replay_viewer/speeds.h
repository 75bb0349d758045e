// The speeds at which a replay is watched, times real time.
#pragma once

#include <iterator>
#include <string>

namespace gw {

inline constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1, 2, 4, 8, 16};

// The next speed up or down; --speed may have set one between two of them.
inline double faster(double speed) {
  for (const double next : kSpeeds) {
    if (next > speed + 1e-9) return next;
  }
  return kSpeeds[std::size(kSpeeds) - 1];
}
inline double slower(double speed) {
  double result = kSpeeds[0];
  for (const double next : kSpeeds) {
    if (next < speed - 1e-9) result = next;
  }
  return result;
}

// Whether sounds are played: at other speeds they would not match the picture.
inline bool isHeardAt(double speed) {
  return speed >= 0.5 && speed <= 2;
}

// "x1/4", "x0.3", "x16"
std::string speedText(double speed);

}  // namespace gw
