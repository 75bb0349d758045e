#include "host/overlay/frame_history.h"

#include <algorithm>
#include <numeric>

#include "host/platform/statistics.h"

namespace gw {

void FrameHistory::add(double frame_ms) {
  if (ring_.size() < kFrames) {
    ring_.push_back(frame_ms);
    return;
  }
  ring_[oldest_] = frame_ms;
  oldest_ = (oldest_ + 1) % kFrames;
}

std::vector<double> FrameHistory::oldestFirst_ms() const {
  std::vector<double> frames_ms(ring_);
  std::rotate(frames_ms.begin(), frames_ms.begin() + ptrdiff_t(oldest_), frames_ms.end());
  return frames_ms;
}

double FrameHistory::mean_ms() const {
  return empty() ? 0 : std::accumulate(ring_.begin(), ring_.end(), 0.0) / double(ring_.size());
}

double FrameHistory::p99_ms() const {
  return empty() ? 0 : profile::percentile(ring_, 99);
}

double FrameHistory::longest_ms() const {
  return empty() ? 0 : *std::max_element(ring_.begin(), ring_.end());
}

}  // namespace gw
