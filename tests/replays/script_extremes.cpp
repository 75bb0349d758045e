// Records that no hand makes, and that the rules must take all the same.
#include "tests/replays/script.h"

namespace gw {

namespace {

constexpr int16_t kFull = kStickFull;

uint16_t asks(uint32_t type, uint32_t number) {
  return uint16_t(kButtonSpawn | type << kSpawnTypeShift | number << kSpawnCountShift);
}

// Both components full, which no stick reaches: held, to and fro every tick, round the square, and held long enough to
// meet every wall. The aim turns by half a turn a tick.
InputRecord sticks(const TickReport& last) {
  const uint32_t tick = last.tick;
  InputRecord record;
  record.aim = uint16_t(tick % 2 * 32768 + tick / 64 * 331);
  record.buttons = kButtonFire;
  const uint32_t phase = tick / 300 % 4, step = phase == 0   ? 0
                                                : phase == 1 ? tick % 2 * 2
                                                : phase == 2 ? tick
                                                             : tick / 75;
  constexpr int kSquare[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  record.move_x = int16_t(kSquare[step % 4][0] * kFull);
  record.move_y = int16_t(kSquare[step % 4][1] * kFull);
  return record;
}

// Every button goes down in every second tick, with every type and number that the bits can say, those that there are
// not included; for a second in ten all bits are set, and every 20 seconds the field is cleared.
InputRecord buttons(const TickReport& last) {
  const uint32_t tick = last.tick, second = tick / kTicksPerSecond;
  InputRecord record;
  record.aim = uint16_t(tick * 5003);
  record.move_x = int16_t(tick / 90 % 2 ? kFull : -kFull);
  if (tick % 2) return record;
  if (second % 10 == 9) {
    record.buttons = kButtonsKnown;
    if (second % 20 != 19) record.buttons &= uint16_t(~kButtonClear);
    return record;
  }
  const uint32_t request = tick / 2;
  record.buttons = uint16_t(kButtonFire | kButtonFlush | asks(request % 8, request / 8 % 16));
  return record;
}

// Hands off.
InputRecord nothing(const TickReport&) {
  return {};
}

// Into each corner of the world in turn, 13 s each, both components full once it is there; ten enemies are asked for
// at each, and shots go towards the middle.
InputRecord corners(const TickReport& last) {
  constexpr float kWidth_m = 192, kHeight_m = 108;  // of a world for up to 8,192 enemies
  constexpr uint32_t kVisit_ticks = 780;
  const uint32_t tick = last.tick, visit = tick / kVisit_ticks;
  const bool right = visit % 4 == 1 || visit % 4 == 2, top = visit % 4 >= 2;
  const bool isAtSide = right ? last.ship_x > kWidth_m - 1 : last.ship_x < 1;
  const bool isAtEnd = top ? last.ship_y > kHeight_m - 1 : last.ship_y < 1;
  InputRecord record;
  if (!isAtSide || isAtEnd) record.move_x = right ? kFull : int16_t(-kFull);
  if (isAtSide) record.move_y = top ? kFull : int16_t(-kFull);
  const uint32_t inwards = top ? (right ? 0xa000 : 0xe000) : (right ? 0x6000 : 0x2000);
  record.aim = uint16_t(inwards + tick % 64 * 128 - 4096);
  record.buttons = kButtonFire;
  if (tick % kVisit_ticks == kVisit_ticks - 240) record.buttons |= asks(visit % 7, 3);
  return record;
}

// Asks for no enemies and flies about, so that a world without enemies is played.
InputRecord alone(const TickReport& last) {
  const uint32_t tick = last.tick;
  constexpr int16_t kSlant = 23170;
  constexpr int16_t kAround[8][2] = {{kFull, 0},  {kSlant, kSlant},   {0, kFull},  {-kSlant, kSlant},
                                     {-kFull, 0}, {-kSlant, -kSlant}, {0, -kFull}, {kSlant, -kSlant}};
  InputRecord record;
  record.move_x = kAround[tick / 40 % 8][0];
  record.move_y = kAround[tick / 40 % 8][1];
  record.aim = uint16_t(tick * 97);
  record.buttons = uint16_t(kButtonFire | (tick % 500 == 499 ? kButtonFlush : 0));
  return record;
}

}  // namespace

void addExtremes(Scripts& scripts) {
  const auto add = [&](const char* name, InputRecord (*script)(const TickReport&)) {
    scripts[name] = [script] { return Script(script); };
  };
  add("sticks", sticks);
  add("buttons", buttons);
  add("nothing", nothing);
  add("corners", corners);
  add("alone", alone);
}

}  // namespace gw
