// What the CPU sends per tick: integers only, quantised before use and before recording, so that a
// replay holds exactly what the kernels saw.
#pragma once

#include <cstdint>

namespace gw {

enum InputButton : uint16_t {
  kButtonFire = 1u << 0,
  kButtonFlush = 1u << 1,
  // Practice only; other modes ignore them. The press of kButtonSpawn asks for kPracticeCounts[number] of a
  // type, both of which stand in the same record; the press of kButtonClear ends all that live.
  kButtonSpawn = 1u << 2,
  kButtonClear = 1u << 3,
};
inline constexpr uint32_t kSpawnTypeShift = 4, kSpawnTypeMask = 7;     // an index into the enemy table
inline constexpr uint32_t kSpawnCountShift = 8, kSpawnCountMask = 15;  // an index into kPracticeCounts
inline constexpr uint32_t kPracticeCounts[] = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000};
inline constexpr uint16_t kButtonsKnown = kButtonFire | kButtonFlush | kButtonSpawn | kButtonClear |
                                          kSpawnTypeMask << kSpawnTypeShift | kSpawnCountMask << kSpawnCountShift;
inline constexpr int16_t kStickFull = 32767;  // a stick component of 1.0; -32768 is never sent

struct InputRecord {
  int16_t move_x = 0, move_y = 0;  // x right, y up; +-kStickFull is full deflection
  uint16_t aim = 0;                // world angle, counter-clockwise from +x, in 1/65536 turns
  uint16_t buttons = 0;            // InputButton bits

  friend bool operator==(const InputRecord&, const InputRecord&) = default;
};
static_assert(sizeof(InputRecord) == 8);

}  // namespace gw
