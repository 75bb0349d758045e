// Bits of an enemy's state word w, and of the events that a tick leaves behind for settle.
#pragma once

#include <cstdint>

namespace gw {

enum EnemyFlag : uint32_t {
  kFlagHit = 1u << 0,      // was hit since it last checked its energy
  kFlagFlushed = 1u << 1,  // dies for its bare value
  kFlagBlasted = 1u << 2,  // dies without score
};

enum EntityEvent : uint32_t {
  kEventTransition = 1u << 0,  // from the state that stands kEventFromShift bits higher
  kEventDied = 1u << 1,
  kEventTaken = 1u << 2,  // a bit that the ship collected
};
inline constexpr uint32_t kEventFromShift = 8;

}  // namespace gw
