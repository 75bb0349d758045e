// sin, cos, atan2 and exp with the same bits on every device and compiler: only + - * / and sqrtf, in a
// fixed order, nothing contracted. Minimax polynomials as published in Cephes (Moshier), Cody-Waite range
// reduction in three parts. Largest errors against double precision, measured by tests/gpu/math/exact_math_test:
//
//   sine, cosine   |x| <= 8192 rad      absolute error below 8e-8 (argument rounded beyond)
//   arcTangent2    all finite pairs     absolute error below 3e-7 rad
//   exponential    |x| <= 87            relative error below 8.5e-8; clamped outside
#pragma once

#include <gpuwars/bits.h>
#include <gpuwars/plain_types.h>

#include <cmath>

namespace gw::GW_DEVICE {

// Half a turn, rad.
inline constexpr float kPi = 3.14159265358979f;
// A turn, rad.
inline constexpr float kTwoPi = 6.28318530717959f;

// Both of one angle.
struct SineCosine {
  float sine, cosine;  // -1 .. 1
};

// Both at once, as every caller needs both. x in radians; NaN and |x| > 8192 count as +-8192.
GW_FN SineCosine sineCosine(float x) {
  const float limited = x >= -8192.0f ? (x <= 8192.0f ? x : 8192.0f) : -8192.0f;
  const float scaled = limited * 0.63661977236758f;  // 2 / pi
  const int32_t quarter = int32_t(scaled >= 0.0f ? scaled + 0.5f : scaled - 0.5f);
  const float k = float(quarter);
  // pi / 2 in three parts; the first two have so few bits that their products with k are exact.
  float r = limited - k * 1.5703125f;
  r = r - k * 4.837512969970703125e-4f;
  r = r - k * 7.549789948768648e-8f;
  const float z = r * r;
  const float s = ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * r + r;
  const float c =
      ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f) * z * z - 0.5f * z + 1.0f;
  const uint32_t turn = uint32_t(quarter) & 3u;
  const float sine = turn & 1u ? c : s, cosine = turn & 1u ? s : c;
  return {turn & 2u ? -sine : sine, turn == 1u || turn == 2u ? -cosine : cosine};
}

// See sineCosine().
GW_FN float sine(float x) {
  return sineCosine(x).sine;
}
// See sineCosine().
GW_FN float cosine(float x) {
  return sineCosine(x).cosine;
}

// The angle of (x, y) in -pi..pi; 0 for (0, 0) whatever the signs of the zeros.
GW_FN float arcTangent2(float y, float x) {
  const float ax = magnitude(x), ay = magnitude(y);
  if (ax == 0.0f && ay == 0.0f) return 0.0f;
  const bool steep = ay > ax;
  float t = steep ? ax / ay : ay / ax;  // 0..1
  float base = 0.0f;
  if (t > 0.4142135623730950f) {  // tan(pi / 8)
    base = 0.785398163397448f;
    t = (t - 1.0f) / (t + 1.0f);
  }
  const float z = t * t;
  const float series =
      (((8.05374449538e-2f * z - 1.38776856032e-1f) * z + 1.99777106478e-1f) * z - 3.33329491539e-1f) * z * t + t;
  float angle = base + series;
  if (steep) angle = 1.570796326794897f - angle;
  if (x < 0.0f) angle = kPi - angle;
  return y < 0.0f ? -angle : angle;
}

// e to the x, for x in -87 .. 87; outside it is that of the nearer end.
GW_FN float exponential(float x) {
  const float limited = x >= -87.0f ? (x <= 87.0f ? x : 87.0f) : -87.0f;
  const float scaled = limited * 1.44269504088896f;  // 1 / ln 2
  const int32_t power = int32_t(scaled >= 0.0f ? scaled + 0.5f : scaled - 0.5f);
  const float k = float(power);
  float r = limited - k * 0.693359375f;
  r = r + k * 2.12194440e-4f;
  const float series =
      (((((1.9875691500e-4f * r + 1.3981999507e-3f) * r + 8.3334519073e-3f) * r + 4.1665795894e-2f) * r +
        1.6666665459e-1f) *
           r +
       5.0000001201e-1f) *
          r * r +
      r + 1.0f;
  return series * floatOf(uint32_t(power + 127) << 23);
}

// The vector's length.
GW_FN float length(float x, float y) {
  return sqrtf(x * x + y * y);
}

// The vector of length one in the same direction; a zero vector stays zero.
GW_FN Float2 normalised(float x, float y) {
  const float l = length(x, y);
  if (!(l > 0.0f)) return {0.0f, 0.0f};
  return {x / l, y / l};
}

}  // namespace gw::GW_DEVICE
