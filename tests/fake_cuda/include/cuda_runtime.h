// The stand-in's view of CUDA C++: kernels compiled as plain C++, whose threads are fibers of this processor. A block
// runs alone and on one thread, so shared memory is thread-local memory, and atomics are plain.
#pragma once

#include <cstdint>
#include <functional>
#include <tuple>
#include <utility>

#include "cuda_runtime_api.h"

#define __host__
#define __device__
#define __global__
#define __forceinline__ inline
#define __launch_bounds__(...)
#define __align__(bytes) __attribute__((aligned(bytes)))
#define __shared__ constinit thread_local

struct uint3 {
  unsigned x, y, z;
};
extern constinit thread_local uint3 threadIdx, blockIdx;
extern constinit thread_local dim3 blockDim, gridDim;
inline constexpr int warpSize = 32;

namespace gw::stand_in {

cudaError_t launch(const cudaLaunchConfig_t& config, const void* kernel, std::function<void()> thread);

void syncBlock();
bool syncBlockOr(bool vote);
void syncWarp(unsigned mask);
// Puts down a word for the other lanes of the warp, waits for those in the mask, and shows what they put down.
const uint64_t* exchange(unsigned mask, uint64_t word);

inline unsigned lane() {
  return threadIdx.x % 32;
}

template <class T>
uint64_t toWord(T value) {
  static_assert(sizeof(T) <= sizeof(uint64_t));
  uint64_t word = 0;
  __builtin_memcpy(&word, &value, sizeof value);
  return word;
}
template <class T>
T fromWord(uint64_t word) {
  T value;
  __builtin_memcpy(&value, &word, sizeof value);
  return value;
}

}  // namespace gw::stand_in

template <class... Parameters, class... Arguments>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t* config, void (*kernel)(Parameters...),
                               Arguments&&... arguments) {
  std::tuple<std::remove_cv_t<Parameters>...> bound(std::forward<Arguments>(arguments)...);
  return gw::stand_in::launch(*config, reinterpret_cast<const void*>(kernel),
                              [kernel, bound] { std::apply(kernel, bound); });
}

inline void __syncthreads() {
  gw::stand_in::syncBlock();
}
inline int __syncthreads_or(int predicate) {
  return gw::stand_in::syncBlockOr(predicate != 0);
}
inline void __syncwarp(unsigned mask = 0xFFFFFFFFu) {
  gw::stand_in::syncWarp(mask);
}
inline void __threadfence() {}
inline void __threadfence_block() {}

template <class T>
T __shfl_sync(unsigned mask, T value, int from, int width = warpSize) {
  const uint64_t* words = gw::stand_in::exchange(mask, gw::stand_in::toWord(value));
  const unsigned first = gw::stand_in::lane() / unsigned(width) * unsigned(width);
  return gw::stand_in::fromWord<T>(words[first + unsigned(from) % unsigned(width)]);
}
template <class T>
T __shfl_xor_sync(unsigned mask, T value, int with, int width = warpSize) {
  const uint64_t* words = gw::stand_in::exchange(mask, gw::stand_in::toWord(value));
  const unsigned own = gw::stand_in::lane(), other = own ^ unsigned(with);
  return gw::stand_in::fromWord<T>(words[other / unsigned(width) > own / unsigned(width) ? own : other]);
}
template <class T>
T __shfl_up_sync(unsigned mask, T value, unsigned by, int width = warpSize) {
  const uint64_t* words = gw::stand_in::exchange(mask, gw::stand_in::toWord(value));
  const unsigned own = gw::stand_in::lane();
  return gw::stand_in::fromWord<T>(words[own % unsigned(width) >= by ? own - by : own]);
}
template <class T>
T __shfl_down_sync(unsigned mask, T value, unsigned by, int width = warpSize) {
  const uint64_t* words = gw::stand_in::exchange(mask, gw::stand_in::toWord(value));
  const unsigned own = gw::stand_in::lane();
  return gw::stand_in::fromWord<T>(words[own % unsigned(width) + by < unsigned(width) ? own + by : own]);
}
inline unsigned __ballot_sync(unsigned mask, int predicate) {
  const uint64_t* words = gw::stand_in::exchange(mask, predicate != 0);
  unsigned ballot = 0;
  for (unsigned l = 0; l < 32; ++l) {
    if (mask >> l & 1u && words[l]) ballot |= 1u << l;
  }
  return ballot;
}
inline int __any_sync(unsigned mask, int predicate) {
  return __ballot_sync(mask, predicate) != 0;
}
inline int __all_sync(unsigned mask, int predicate) {
  return __ballot_sync(mask, !predicate) == 0;
}
inline unsigned __match_any_sync(unsigned mask, uint64_t value) {
  const uint64_t* words = gw::stand_in::exchange(mask, value);
  unsigned same = 0;
  for (unsigned l = 0; l < 32; ++l) {
    if (mask >> l & 1u && words[l] == value) same |= 1u << l;
  }
  return same;
}

inline int __popc(unsigned word) {
  return __builtin_popcount(word);
}
inline int __popcll(unsigned long long word) {
  return __builtin_popcountll(word);
}
inline int __clz(int word) {
  return word == 0 ? 32 : __builtin_clz(unsigned(word));
}
inline int __ffs(int word) {
  return __builtin_ffs(word);
}
inline unsigned __umulhi(unsigned a, unsigned b) {
  return unsigned(uint64_t(a) * b >> 32);
}
template <class T>
T __ldg(const T* address) {
  return *address;
}

template <class T>
T atomicAdd(T* word, T amount) {
  const T before = *word;
  *word = before + amount;
  return before;
}
template <class T>
T atomicMax(T* word, T value) {
  const T before = *word;
  if (before < value) *word = value;
  return before;
}
template <class T>
T atomicMin(T* word, T value) {
  const T before = *word;
  if (value < before) *word = value;
  return before;
}
template <class T>
T atomicOr(T* word, T bits) {
  const T before = *word;
  *word = before | bits;
  return before;
}
template <class T>
T atomicExch(T* word, T value) {
  const T before = *word;
  *word = value;
  return before;
}
template <class T>
T atomicCAS(T* word, T expected, T value) {
  const T before = *word;
  if (before == expected) *word = value;
  return before;
}
