// Inspection of a running game: every value by name after every stage of a tick, and the raw bytes of its memory. For
// the desync finder and for tests. Slow: play never uses it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "game/sim/simulation.h"

namespace gw {

// How the bits of a value are read: `real` is a 32-bit float.
enum class ValueKind : uint32_t { whole, real };

// The values of one field.
struct Column {
  std::string name;
  ValueKind kind;
  std::shared_ptr<const std::vector<uint64_t>> values;  // shared with the stage before, where nothing changed
};

// What one stage left.
struct StageState {
  std::string stage;
  std::vector<Column>
      entities;  // by id, 0 where no entity lives; [0] is the type (kTypeNone there), [1] and [2] the place
  std::vector<Column> globals;  // one value each
};

// What damage to a byte between two ticks does.
enum class Standing : uint32_t {
  hashed,     // the next hash shows it
  ofLiving,   // so it does where an entity lives; elsewhere birth writes the byte before it is read
  rewritten,  // the next tick writes it before it is read
  unread,     // never read
  costOnly,   // what is found is the same, at more or less work
};

// Bytes of one buffer with one effect of damage, in every element.
struct BytesOfBuffer {
  std::string buffer, part;
  Standing standing;
  std::string why;    // empty where a hash shows it
  uint8_t* d_bytes;   // of the first element
  uint32_t bytes;     // of the part, in one element
  uint32_t stride;    // bytes from one element to the next
  uint32_t elements;  // by id, unless:
  bool byCell = false;
};

class Inspection {
 public:
  virtual ~Inspection() = default;

  // One tick, waited for after each stage. Throws std::logic_error while others are queued.
  using AfterStage = std::function<void(const std::string& stage)>;
  virtual TickReport tickByStages(const InputRecord& input, const AfterStage& after) = 0;

  // Only within AfterStage. `before` is the stage before, or null.
  virtual StageState stateAfter(const std::string& stage, const StageState* before) = 0;

  // All memory that the game keeps from tick to tick or within one; the roles of sides that alternate are those of
  // the running tick, or of the last one.
  virtual std::vector<BytesOfBuffer> bytes() = 0;
  // Turns over one bit of a part, counted from its first byte. For tests.
  virtual void flip(const BytesOfBuffer& part, uint32_t element, uint32_t bit) = 0;
};

}  // namespace gw
