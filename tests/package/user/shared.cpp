// A shared library with a plain C interface, for ctypes and for module.cpp: once with a queue for each call, and once
// with one that is kept between calls.
#include "shared.h"

#include <gpuwars/exec.h>

#include <memory>

#include "count.h"

namespace {

std::unique_ptr<gw::cpu::Queue>& keptQueue() {
  static std::unique_ptr<gw::cpu::Queue> queue;
  return queue;
}

std::vector<gw::Cell> pointsOf(const float* xy, uint32_t count) {
  std::vector<gw::Cell> points;
  for (uint32_t i = 0; i < count; ++i) points.push_back({xy[2 * i], xy[2 * i + 1], i, 0});
  return points;
}

}  // namespace

uint64_t count_pairs(const float* xy, uint32_t count, float radius) {
  return gw::cpu::countPairs(gw::ExecOptions{2}, pointsOf(xy, count), radius);
}

uint64_t count_pairs_with_kept_queue(const float* xy, uint32_t count, float radius) {
  if (!keptQueue()) keptQueue() = std::make_unique<gw::cpu::Queue>(gw::ExecOptions{2});
  return gw::cpu::countPairs(*keptQueue(), pointsOf(xy, count), radius);
}

void drop_kept_queue() {
  keptQueue().reset();
}
