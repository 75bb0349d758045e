// One side of a comparison: a recorded run that is played on request and says what it sees, from a hash per tick down
// to single values. The other side may be another device, another number of threads, or another build in another
// process; so what crosses is small, and fields and stages go by their names.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "game/sim/debug/inspection.h"

namespace gw {

inline constexpr uint32_t kBlockIds = 256;  // entities per block of hashes

struct FieldHash {
  std::string field;
  uint64_t hash = 0;  // of all its values

  friend bool operator==(const FieldHash&, const FieldHash&) = default;
};

struct StageHashes {
  std::string stage;
  std::vector<FieldHash> entities, globals;
};

struct FieldValue {
  std::string field;
  ValueKind kind = ValueKind::whole;
  uint64_t bits = 0;

  friend bool operator==(const FieldValue&, const FieldValue&) = default;
};

struct NearEntity {
  uint32_t id = 0, type = 0;
  float distance_m = 0;

  friend bool operator==(const NearEntity&, const NearEntity&) = default;
};

class Probe {
 public:
  virtual ~Probe() = default;

  virtual std::string name() const = 0;  // "cpu, 2 threads"

  virtual void restart() = 0;                              // to before the first tick
  virtual std::vector<uint64_t> play(uint32_t ticks) = 0;  // on from there: the hash after each; at most to the end
  virtual void keep() = 0;                                 // where it is now...
  virtual void goBack() = 0;                               // ...and to there, or to the start

  // The next tick. What follows asks about its stages, until the run moves on.
  virtual std::vector<StageHashes> playByStages() = 0;
  virtual std::vector<uint64_t> blocks(const std::string& stage, const std::string& field) = 0;  // hashes
  // Of the ids of one block, the last of which may be short.
  virtual std::vector<uint64_t> values(const std::string& stage, const std::string& field, uint32_t block) = 0;
  virtual FieldValue global(const std::string& stage, const std::string& field) = 0;
  virtual std::vector<FieldValue> entity(const std::string& stage, uint32_t id) = 0;
  // The `count` nearest to it, the nearest first; ties by id.
  virtual std::vector<NearEntity> around(const std::string& stage, uint32_t id, uint32_t count) = 0;
};

}  // namespace gw
