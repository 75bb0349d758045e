// The enemies' state machines as data: kernels, tests and documents read the same rows. Each tick the
// first row that applies is taken, or none.
#pragma once

#include <cstdint>

#include "game/sim/rules.h"

namespace gw {

enum class State : uint32_t { wandering, attacking, checkingEnergy, dead, count };

// What a think kernel finds out about an entity this tick.
enum Condition : uint32_t {
  kDamaged = 1u << 0,     // was hit since it last checked
  kEnergyGone = 1u << 1,  // energy <= 0
  kSeesShip = 1u << 2,    // within its sight
  kLostShip = 1u << 3,    // beyond Rules::Steering::sightLost times its sight
};
inline constexpr uint32_t kConditionCount = 4;

constexpr uint32_t in(State state) {
  return 1u << uint32_t(state);
}

struct Transition {
  uint32_t from;   // bits of the states it leaves: in(State) | ...
  uint32_t needs;  // Condition bits that must all hold
  State to;
};

inline constexpr uint32_t kMaxTransitions = 8;

struct MachineTable {
  uint32_t count;
  Transition rows[kMaxTransitions];
};

// RULES: damage interrupts every living state; checking decides between death, attack and wandering.
inline constexpr MachineTable kKamikaze = {
    6,
    {{in(State::wandering) | in(State::attacking) | in(State::checkingEnergy), kDamaged, State::checkingEnergy},
     {in(State::checkingEnergy), kEnergyGone, State::dead},
     {in(State::checkingEnergy), kSeesShip, State::attacking},
     {in(State::checkingEnergy), 0, State::wandering},
     {in(State::wandering), kSeesShip, State::attacking},
     {in(State::attacking), kLostShip, State::wandering}}};

constexpr const char* nameOf(State state) {
  constexpr const char* kNames[] = {"wandering", "attacking", "checking energy", "dead"};
  return kNames[uint32_t(state)];
}

}  // namespace gw
