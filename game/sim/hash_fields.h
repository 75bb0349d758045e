// The parts of the state hash: words of entities by what they hold, the arrangement of the cells where it is
// state, and the master's globals (with them the tables, should they be damaged). Their sums add up to the hash;
// replays keep them, so that a difference can be said to lie in one of them.
#pragma once

#include <cstdint>

namespace gw {

// The numbers are written in replays, and those of entities key the words that are hashed: add at the end only.
enum class HashField : uint32_t {
  typeAndBirth,
  place,
  velocity,
  placeBefore,
  force,
  energyAndMass,
  direction,
  push,
  stateAndTimer,
  cooldownAndFlags,
  target,
  arrangement,
  master,
  count
};
inline constexpr uint32_t kHashFields = uint32_t(HashField::count);
inline constexpr uint32_t kEntityHashFields = uint32_t(HashField::arrangement);  // those before it

inline constexpr const char* kHashFieldNames[kHashFields] = {
    "type and birth tick", "place", "velocity",        "place before",       "force",  "energy and mass",
    "direction",           "push",  "state and timer", "cooldown and flags", "target", "arrangement",
    "master and tables"};

}  // namespace gw
