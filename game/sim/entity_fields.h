// The fields of an entity and the buffers that hold them: the one table of both. From its rows are made the record that
// snapshots hold, the buffers of a game and the kernels' view of them, births, the state hash, snapshots, the columns
// of the state dump and the list of what damage to a byte does.
//
// A new field of an entity is a row of GW_ENTITY_FIELDS and the code that uses it. When no component of a buffer is
// free it also takes a row of GW_STATE_BUFFERS, and when no half of a hash word is free, one of GW_HASH_FIELDS.
#pragma once

#include <cstddef>
#include <iterator>
#include <type_traits>

#include "game/sim/hash_fields.h"
#include "gpu/math/plain_types.h"

namespace gw {

// Buffers by id that outlive a tick. ONE(name, Type) is a buffer that stages write in place. TWO(name, next, Type) is a
// pair that alternates (double buffering): stages read `name`, the start of the tick, until think writes `next`.
#define GW_STATE_BUFFERS(ONE, TWO)              \
  TWO(forceEnergy, nextForceEnergy, Float4)     \
  TWO(directionMass, nextDirectionMass, Float4) \
  ONE(velocityPrevious, Float4)                 \
  ONE(state, Uint4)                             \
  ONE(push, Float2)                             \
  ONE(birthTick, uint32_t)                      \
  ONE(target, uint32_t)

// FIELD(member, Type, buffer, component, column, hash word, its half). Position and type are in the cell, everything
// else in a buffer of GW_STATE_BUFFERS, in `component` of its element. Shots and bits use some fields in their own way.
//   force          N
//   energy         a shot's damage
//   direction      unit vector
//   velocity       m/s
//   previous       position one tick ago, m
//   push           velocity that contact response adds in the next tick, m/s
//   state          a State
//   timer          ticks of life left (shots, bits), of avoiding left (enemies)
//   cooldown       hits left (shots), ticks until the next dodge (enemies)
//   flags          EnemyFlag; a shot's victim before last
//   target         a shot's last victim, or kNobody
#define GW_ENTITY_FIELDS(FIELD)                                                                        \
  FIELD(type, uint32_t, cell, .type, "type", HashField::typeAndBirth, kHighHalf)                       \
  FIELD(x, float, cell, .x, "x", HashField::position, kHighHalf)                                       \
  FIELD(y, float, cell, .y, "y", HashField::position, kLowHalf)                                        \
  FIELD(velocity_x, float, velocityPrevious, .x, "velocity_x", HashField::velocity, kHighHalf)         \
  FIELD(velocity_y, float, velocityPrevious, .y, "velocity_y", HashField::velocity, kLowHalf)          \
  FIELD(previous_x, float, velocityPrevious, .z, "previous_x", HashField::previousPosition, kHighHalf) \
  FIELD(previous_y, float, velocityPrevious, .w, "previous_y", HashField::previousPosition, kLowHalf)  \
  FIELD(force_x, float, forceEnergy, .x, "force_x", HashField::force, kHighHalf)                       \
  FIELD(force_y, float, forceEnergy, .y, "force_y", HashField::force, kLowHalf)                        \
  FIELD(energy, float, forceEnergy, .w, "energy", HashField::energyAndMass, kHighHalf)                 \
  FIELD(direction_x, float, directionMass, .x, "direction_x", HashField::direction, kHighHalf)         \
  FIELD(direction_y, float, directionMass, .y, "direction_y", HashField::direction, kLowHalf)          \
  FIELD(mass, float, directionMass, .z, "mass", HashField::energyAndMass, kLowHalf)                    \
  FIELD(push_x, float, push, .x, "push_x", HashField::push, kHighHalf)                                 \
  FIELD(push_y, float, push, .y, "push_y", HashField::push, kLowHalf)                                  \
  FIELD(state, uint32_t, state, .x, "state", HashField::stateAndTimer, kHighHalf)                      \
  FIELD(timer, uint32_t, state, .y, "timer", HashField::stateAndTimer, kLowHalf)                       \
  FIELD(cooldown, uint32_t, state, .z, "cooldown", HashField::cooldownAndFlags, kHighHalf)             \
  FIELD(flags, uint32_t, state, .w, "flags", HashField::cooldownAndFlags, kLowHalf)                    \
  FIELD(birthTick, uint32_t, birthTick, , "birth_tick", HashField::typeAndBirth, kLowHalf)             \
  FIELD(target, uint32_t, target, , "target", HashField::target, kLowHalf)

// Buffers by id that hold values within one tick only, written before they are read. BUFFER(name, Type, how many of it
// per id, the stage from which on the state dump shows it, its columns...).
//   threat         the nearest shot that approaches: ~(squared distance's bits << 32 | id); 0: none
//   event          EntityEvent bits
//   choice         the victim that a shot picked, or kNobody
//   choiceTime     when in the tick it meets it, 0..1
//   chosenBy       how many shots picked this victim
//   spent          1: the shot's hit was taken
//   pushSum        x and y of the pushes, and their lengths; fixed point, two's complement
#define GW_TICK_BUFFERS(BUFFER)                          \
  BUFFER(threat, uint64_t, 1, "think", "threat")         \
  BUFFER(event, uint32_t, 1, "think", "event")           \
  BUFFER(choice, uint32_t, 1, "collide", "choice")       \
  BUFFER(choiceTime, float, 1, "collide", "choice_time") \
  BUFFER(chosenBy, uint32_t, 1, "collide", "chosen_by")  \
  BUFFER(spent, uint32_t, 1, "collide", "spent")         \
  BUFFER(pushSum, uint64_t, 3, "collide", "push_sum_x", "push_sum_y", "push_lengths")

enum HashHalf : uint32_t { kLowHalf = 0, kHighHalf = 32 };

// One live entity, as snapshots hold it: everything that is simulated, by id, nothing of the NGrid's
// arrangement.
struct EntityRecord {
  uint32_t id;
#define GW_DECLARE(member, Type, ...) Type member;
  GW_ENTITY_FIELDS(GW_DECLARE)
#undef GW_DECLARE
};

// The same as it lies in device memory: its cell, and its element of each buffer of state.
struct EntityElements {
  Cell cell;
#define GW_ONE(name, Type) Type name;
#define GW_TWO(name, next, Type) Type name;
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO
};

// The buffers by number, for tables by buffer.
enum class StateBuffer : uint32_t {
  cell,
#define GW_ONE(name, Type) name,
#define GW_TWO(name, next, Type) name,
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO
      count
};

// The rows of GW_ENTITY_FIELDS as data, for host code that walks over them.
struct EntityField {
  const char* column;
  bool isFloat;
  size_t recordOffset;  // in EntityRecord
  StateBuffer buffer;
  size_t elementOffset;  // in EntityElements
  HashField hashField;
  HashHalf half;
};
inline constexpr EntityField kEntityFields[] = {
#define GW_ROW(member, Type, buffer, component, column, word, half) \
  {column,                                                          \
   std::is_floating_point_v<Type>,                                  \
   offsetof(EntityRecord, member),                                  \
   StateBuffer::buffer,                                             \
   offsetof(EntityElements, buffer component),                      \
   word,                                                            \
   half},
    GW_ENTITY_FIELDS(GW_ROW)
#undef GW_ROW
};
static_assert(sizeof(EntityRecord) == 4 * (1 + std::size(kEntityFields)), "an id and fields of 32 bits, without gaps");

// Whether each word of the hash has something in it, and no half of a word two fields.
constexpr bool hashesAreWhole() {
  uint32_t taken[kEntityHashFields][2] = {};
  for (const EntityField& field : kEntityFields) {
    if (uint32_t(field.hashField) >= kEntityHashFields) return false;
    if (++taken[uint32_t(field.hashField)][field.half / 32] > 1) return false;
  }
  for (const auto& halves : taken) {
    if (halves[0] + halves[1] == 0) return false;
  }
  return true;
}
static_assert(hashesAreWhole());

}  // namespace gw
