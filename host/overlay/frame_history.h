// The times of the last few seconds' frames: what the graph of the overlay shows.
#pragma once

#include <cstddef>
#include <vector>

namespace gw {

class FrameHistory {
 public:
  static constexpr size_t kFrames = 240;

  // The oldest gives way once there are kFrames.
  void add(double frame_ms);
  void clear() { *this = {}; }

  bool empty() const { return ring_.empty(); }
  std::vector<double> oldestFirst_ms() const;

  // As `gpuwars profile` has them (docs/guide/profile.md), over what is remembered; 0 while nothing is.
  double mean_ms() const;
  double p99_ms() const;
  double longest_ms() const;

 private:
  std::vector<double> ring_;  // kFrames at most; then oldest_ is the next to be overwritten
  size_t oldest_ = 0;
};

}  // namespace gw
