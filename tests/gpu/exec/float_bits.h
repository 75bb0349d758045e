// Puts a thread's floating-point state out of order, as some libraries do.
#pragma once

#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace gw::test {

#if defined(__x86_64__)

enum class FloatBits : uint32_t { flush = 0x8000, flushOperands = 0x0040, down = 0x2000, up = 0x4000, zero = 0x6000 };
inline constexpr FloatBits kAllFloatBits[] = {FloatBits::flush, FloatBits::flushOperands, FloatBits::down,
                                              FloatBits::up, FloatBits::zero};

inline void addFloatBits(FloatBits bits) {
  _mm_setcsr(_mm_getcsr() | uint32_t(bits));
}

#elif defined(__aarch64__)

enum class FloatBits : uint64_t {
  flush = 1u << 24,
  defaultNan = 1u << 25,
  alternativeHalves = 1u << 26,
  up = 1u << 22,
  down = 2u << 22,
  zero = 3u << 22,
};
inline constexpr FloatBits kAllFloatBits[] = {FloatBits::flush, FloatBits::defaultNan, FloatBits::alternativeHalves,
                                              FloatBits::up,    FloatBits::down,       FloatBits::zero};

inline void addFloatBits(FloatBits bits) {
  uint64_t control = 0;
  asm volatile("mrs %0, fpcr" : "=r"(control));
  asm volatile("msr fpcr, %0" : : "r"(control | uint64_t(bits)));
}

#endif

inline bool flushesSubnormals() {
  volatile float least = 1.17549435e-38f;
  volatile float half = least * 0.5f;
  return half == 0.0f;
}

// 1 + 2^-24 and 1 + 3 * 2^-24 lie in the middle between two floats: only round to nearest, ties to even, goes down
// for the one and up for the other; and -1 - 2^-24 tells the other modes apart.
inline bool roundsToNearestEven() {
  volatile float one = 1, half = 5.9604644775390625e-8f, threeHalves = 3 * 5.9604644775390625e-8f;
  volatile float low = one + half, high = one + threeHalves, negative = -one - half;
  return low == 1 && high == 1 + 4 * 5.9604644775390625e-8f && negative == -1;
}

}  // namespace gw::test
