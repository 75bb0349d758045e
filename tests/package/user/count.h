// What main.cpp and shared.cpp see of kernels/count.cu.
#pragma once

#include <gpuwars/exec_options.h>
#include <gpuwars/plain_types.h>

#include <vector>

namespace gw::cpu {
class Queue;
uint64_t countPairs(Queue& queue, const std::vector<Cell>& points, float radius);
uint64_t countPairs(const ExecOptions& options, const std::vector<Cell>& points, float radius);
}  // namespace gw::cpu
#ifdef GW_HAVE_CUDA
namespace gw::cuda {
uint64_t countPairs(const ExecOptions& options, const std::vector<Cell>& points, float radius);
}
#endif
