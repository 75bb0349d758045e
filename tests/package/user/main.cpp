// Reads points, two numbers each, and prints how many neighbours within 3 m they have together.
#include <cstdio>

#include "buffer.h"
#include "count.h"
#include "gpu/buffer.h"  // this project's own

int main() {
  mine::Buffer points;
  float x = 0.0f, y = 0.0f;
  while (std::scanf("%f %f", &x, &y) == 2) points.push_back({x, y, 0, 0});
  std::printf("cpu %llu\n", static_cast<unsigned long long>(gw::cpu::countPairs(gw::ExecOptions{}, points, 3.0f)));
#ifdef GW_HAVE_CUDA
  std::printf("kernels for cuda: %d\n", static_cast<uint64_t (*)(const gw::ExecOptions&, const mine::Buffer&, float)>(
                                            gw::cuda::countPairs) != nullptr);
#endif
  return 0;
}
