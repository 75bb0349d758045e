// The parts of the state hash: words of entities by what they hold, the arrangement of the cells where it is
// state, and the game's globals (with them the tables, should they be damaged). Their sums add up to the hash; replays
// keep them, so that a difference can be located in one of them.
#pragma once

#include <cstdint>

namespace gw {

// FIELD(name, text). Words of entities come before `arrangement`; game/sim/entity_fields.h says what each holds. The
// numbers are written in replays, and those of entities key the words that are hashed: never reorder.
#define GW_HASH_FIELDS(FIELD)                   \
  FIELD(typeAndBirth, "type and birth tick")    \
  FIELD(position, "place")                      \
  FIELD(velocity, "velocity")                   \
  FIELD(previousPosition, "place before")       \
  FIELD(force, "force")                         \
  FIELD(energyAndMass, "energy and mass")       \
  FIELD(direction, "direction")                 \
  FIELD(push, "push")                           \
  FIELD(stateAndTimer, "state and timer")       \
  FIELD(cooldownAndFlags, "cooldown and flags") \
  FIELD(target, "target")                       \
  FIELD(arrangement, "arrangement")             \
  FIELD(globals, "master and tables")

#define GW_NUMBER(name, text) name,
enum class HashField : uint32_t { GW_HASH_FIELDS(GW_NUMBER) count };
#undef GW_NUMBER
inline constexpr uint32_t kHashFields = uint32_t(HashField::count);
inline constexpr uint32_t kEntityHashFields = uint32_t(HashField::arrangement);  // those before it

#define GW_TEXT(name, text) text,
inline constexpr const char* kHashFieldNames[kHashFields] = {GW_HASH_FIELDS(GW_TEXT)};
#undef GW_TEXT

}  // namespace gw
