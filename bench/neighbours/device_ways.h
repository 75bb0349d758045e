// The ways to find neighbours of the device that was asked for, by kind of cell.
#pragma once

#include "bench/neighbours/contender.h"

namespace gw::bench {

#ifdef GW_HAVE_CUDA
namespace perhaps_cuda = cuda;
#else
namespace perhaps_cuda = cpu;  // never asked: takesCuda() has refused before
#endif

template <class CellT>
std::vector<Way> waysOf(bool onCuda);
template <>
inline std::vector<Way> waysOf<Cell>(bool onCuda) {
  return onCuda ? perhaps_cuda::ways2() : cpu::ways2();
}
template <>
inline std::vector<Way> waysOf<Cell3>(bool onCuda) {
  return onCuda ? perhaps_cuda::ways3() : cpu::ways3();
}

inline std::unique_ptr<Contender<Cell>> make(const Cell*, bool onCuda, size_t way, const ExecOptions& options,
                                             const Place& place, uint32_t n) {
  const auto makeOne = onCuda ? perhaps_cuda::makeContender2 : cpu::makeContender2;
  return makeOne(way, options, place, n);
}
inline std::unique_ptr<Contender<Cell3>> make(const Cell3*, bool onCuda, size_t way, const ExecOptions& options,
                                              const Place& place, uint32_t n) {
  const auto makeOne = onCuda ? perhaps_cuda::makeContender3 : cpu::makeContender3;
  return makeOne(way, options, place, n);
}

}  // namespace gw::bench
