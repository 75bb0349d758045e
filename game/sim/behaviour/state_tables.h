// The enemies' state machines as data: kernels, tests and documents read the same rows. Each tick the
// first row that applies is taken, or none.
#pragma once

#include <cstdint>
#include <string_view>

namespace gw {

enum class State : uint32_t { wandering, grouping, attacking, avoiding, escaping, checkingEnergy, dead, count };
inline constexpr uint32_t kStates = uint32_t(State::count);

// What a think kernel finds out about an entity this tick.
enum Condition : uint32_t {
  kDamaged = 1u << 0,     // was hit since it last checked
  kEnergyGone = 1u << 1,  // energy <= 0
  kEnergyLow = 1u << 2,   // under Rules::Steering::escapeBelow of its full energy
  kRecovered = 1u << 3,   // at least Rules::Steering::recoveredAt of its full energy
  kAvoided = 1u << 4,     // has avoided for Rules::Steering::avoid_ticks
  kShotComing = 1u << 5,  // a shot ahead would hit or graze it, and its cooldown is over
  kSeesShip = 1u << 6,    // within its sight
  kLostShip = 1u << 7,    // beyond Rules::Steering::sightLost times its sight
  kOwnKind = 1u << 8,     // one of its own type within its vision
  kAlone = 1u << 9,       // none of its own type within its vision; neither of the two: not gathered in this tick
};
inline constexpr uint32_t kConditionCount = 10;

constexpr uint32_t in(State state) {
  return 1u << uint32_t(state);
}
template <class... States>
constexpr uint32_t in(State first, States... others) {
  return in(first) | in(others...);
}

struct Transition {
  uint32_t from;   // the states it leaves: in(State, ...)
  uint32_t needs;  // Condition bits that must all hold
  State to;
};

inline constexpr uint32_t kMaxTransitions = 16;

struct MachineTable {
  uint32_t count;
  Transition rows[kMaxTransitions];
};

// Damage interrupts every living state; checking decides between death, attack and wandering.
inline constexpr MachineTable kKamikaze = {
    6,
    {{in(State::wandering, State::attacking, State::checkingEnergy), kDamaged, State::checkingEnergy},
     {in(State::checkingEnergy), kEnergyGone, State::dead},
     {in(State::checkingEnergy), kSeesShip, State::attacking},
     {in(State::checkingEnergy), 0, State::wandering},
     {in(State::wandering), kSeesShip, State::attacking},
     {in(State::attacking), kLostShip, State::wandering}}};

// Flies with its own kind, and dodges.
inline constexpr MachineTable kGroup = {
    11,
    {{in(State::wandering, State::grouping, State::attacking, State::avoiding, State::checkingEnergy), kDamaged,
      State::checkingEnergy},
     {in(State::checkingEnergy), kEnergyGone, State::dead},
     {in(State::checkingEnergy), kSeesShip, State::attacking},
     {in(State::checkingEnergy), 0, State::wandering},
     {in(State::avoiding), kAvoided, State::wandering},
     {in(State::wandering, State::grouping, State::attacking), kShotComing, State::avoiding},
     {in(State::wandering, State::grouping), kSeesShip, State::attacking},
     {in(State::wandering), kOwnKind, State::grouping},
     {in(State::attacking), kLostShip | kOwnKind, State::grouping},
     {in(State::attacking), kLostShip, State::wandering},
     {in(State::grouping), kAlone, State::wandering}}};

// The same, and flees to recover when its energy is low.
inline constexpr MachineTable kTricky = {
    13,
    {{in(State::wandering, State::grouping, State::attacking, State::avoiding, State::escaping, State::checkingEnergy),
      kDamaged, State::checkingEnergy},
     {in(State::checkingEnergy), kEnergyGone, State::dead},
     {in(State::checkingEnergy), kEnergyLow, State::escaping},
     {in(State::checkingEnergy), kSeesShip, State::attacking},
     {in(State::checkingEnergy), 0, State::wandering},
     {in(State::escaping), kRecovered, State::wandering},
     {in(State::avoiding), kAvoided, State::wandering},
     {in(State::wandering, State::grouping, State::attacking), kShotComing, State::avoiding},
     {in(State::wandering, State::grouping), kSeesShip, State::attacking},
     {in(State::wandering), kOwnKind, State::grouping},
     {in(State::attacking), kLostShip | kOwnKind, State::grouping},
     {in(State::attacking), kLostShip, State::wandering},
     {in(State::grouping), kAlone, State::wandering}}};

// The state machines. A new one is its table above, a row here, its steering (behaviour_NAME.h) and the line in think
// that asks for it. Replays hold the numbers: add at the end only.
#define GW_MACHINES(MACHINE)   \
  MACHINE(kamikaze, kKamikaze) \
  MACHINE(group, kGroup)       \
  MACHINE(tricky, kTricky)

#define GW_NUMBER(name, table) name,
enum class Machine : uint32_t { GW_MACHINES(GW_NUMBER) count };
#undef GW_NUMBER
inline constexpr uint32_t kMachines = uint32_t(Machine::count);

constexpr const MachineTable& tableOf(Machine machine) {
  switch (machine) {
#define GW_CASE(name, table) \
  case Machine::name:        \
    return table;
    GW_MACHINES(GW_CASE)
#undef GW_CASE
    default:
      return kKamikaze;
  }
}

#define GW_NAME(name, table) #name,
inline constexpr std::string_view kMachineNames[kMachines] = {GW_MACHINES(GW_NAME)};
#undef GW_NAME

// The machines whose table has a row that needs one of these conditions, a bit each.
constexpr uint32_t machinesThatNeed(uint32_t conditions) {
  uint32_t machines = 0;
  for (uint32_t m = 0; m < kMachines; ++m) {
    const MachineTable& table = tableOf(Machine(m));
    for (uint32_t row = 0; row < table.count; ++row) {
      if (table.rows[row].needs & conditions) machines |= 1u << m;
    }
  }
  return machines;
}
inline constexpr uint32_t kDodgingMachines = machinesThatNeed(kShotComing);
inline constexpr uint32_t kFlockingMachines = machinesThatNeed(kOwnKind | kAlone);  // gather their own kind

// Whether some row leads from one state to another. A row that leads back to its own state changes nothing
// and is no edge.
constexpr bool hasEdge(Machine machine, State from, State to) {
  const MachineTable& table = tableOf(machine);
  for (uint32_t row = 0; row < table.count; ++row) {
    if (from != to && (table.rows[row].from & in(from)) && table.rows[row].to == to) return true;
  }
  return false;
}

// In these states flocking machines gather their own kind: no other row or steering needs it.
inline constexpr uint32_t kLooksAround = in(State::wandering, State::grouping, State::attacking);

// How often each transition was taken: by machine, state left, state entered.
struct Edges {
  uint32_t taken[kMachines][kStates][kStates] = {};
};

constexpr const char* nameOf(State state) {
  constexpr const char* kNames[] = {"wandering", "grouping",        "attacking", "avoiding bullets",
                                    "escaping",  "checking energy", "dead"};
  return kNames[uint32_t(state)];
}

// What one Condition bit means, in words for readers.
constexpr const char* nameOf(Condition condition) {
  switch (condition) {
    case kDamaged:
      return "damaged";
    case kEnergyGone:
      return "no energy left";
    case kEnergyLow:
      return "energy low";
    case kRecovered:
      return "recovered";
    case kAvoided:
      return "dodge done";
    case kShotComing:
      return "shot coming";
    case kSeesShip:
      return "sees the ship";
    case kLostShip:
      return "lost the ship";
    case kOwnKind:
      return "own type near";
    case kAlone:
      return "own type gone";
  }
  return "";
}

constexpr const char* nameOf(Machine machine) {
  return kMachineNames[uint32_t(machine)].data();  // of literals, so it ends in 0
}

}  // namespace gw
