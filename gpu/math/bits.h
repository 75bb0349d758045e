// Reading a float's bits and back; and the few float helpers whose bits must be equal everywhere.
#pragma once

#include <gpuwars/device.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace gw::GW_DEVICE {

// Positive infinity: the place of the dead.
inline constexpr float kInfinity = __builtin_inff();

// The bits of a float, as memory holds them.
GW_FN uint32_t bitsOf(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}

// The float with these bits.
GW_FN float floatOf(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

// Ternaries, not fminf and fmaxf: those may pick either zero, and drop NaN differently.
GW_FN float smaller(float a, float b) {
  return b < a ? b : a;
}
// As smaller().
GW_FN float larger(float a, float b) {
  return a < b ? b : a;
}
// The value, but at least `low` and at most `high`; NaN stays NaN.
GW_FN float clamp(float value, float low, float high) {
  return value < low ? low : (high < value ? high : value);
}
// Clears the sign bit: exact everywhere.
GW_FN float magnitude(float value) {
  return fabsf(value);
}

// The smaller of two whole numbers.
GW_FN uint32_t smaller(uint32_t a, uint32_t b) {
  return b < a ? b : a;
}
// The larger of two whole numbers.
GW_FN uint32_t larger(uint32_t a, uint32_t b) {
  return a < b ? b : a;
}

// Bits that tell the numbers below `count` apart; at least 1.
GW_FN uint32_t bitsBelow(uint32_t count) {
  uint32_t bits = 1;
  while (bits < 32 && (count - 1) >> bits) ++bits;
  return bits;
}

// Maps a float that is not NaN to an integer with the same order.
GW_FN uint32_t orderedBits(float value) {
  const uint32_t bits = bitsOf(value);
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

}  // namespace gw::GW_DEVICE
