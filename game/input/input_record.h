// What the CPU sends per tick: integers only, quantised before use and before recording, so that a
// replay holds exactly what the kernels saw.
#pragma once

#include <cstdint>

namespace gw {

enum InputButton : uint16_t {
  kButtonFire = 1u << 0,
  kButtonFlush = 1u << 1,
};
inline constexpr uint16_t kButtonsKnown = kButtonFire | kButtonFlush;
inline constexpr int16_t kStickFull = 32767;  // a stick component of 1.0; -32768 is never sent

struct InputRecord {
  int16_t move_x = 0, move_y = 0;  // x right, y up; +-kStickFull is full deflection
  uint16_t aim = 0;                // world angle, counter-clockwise from +x, in 1/65536 turns
  uint16_t buttons = 0;            // InputButton bits

  friend bool operator==(const InputRecord&, const InputRecord&) = default;
};
static_assert(sizeof(InputRecord) == 8);

}  // namespace gw
