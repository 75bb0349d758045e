// A replay in memory: all that is needed to play a run again and to check every tick of it.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "game/replay/format.h"
#include "game/sim/input_record.h"
#include "game/sim/simulation.h"
#include "game/tables/rule_texts.h"
#include "host/platform/atomic_file.h"

namespace gw {

// What is wrong in a replay.
struct ReplayError : FileError {
  using FileError::FileError;
};

// What is known before the first tick.
struct ReplayHeader {
  uint64_t seed = 1;
  Mode mode = Mode::arcade;
  uint32_t enemies = 8192;                // capacity, 1 to kMaxEnemies
  Autopilot autopilot = Autopilot::none;  // who played; the inputs hold what it did
  uint32_t simulationVersion = kSimulationVersion;
  std::string options;  // the command line, for people; nothing reads it back
  // With an inexact gather the arrangement of the NGrid is state: it is played again with the same.
  Gather gather = Gather::exact;
  Sort sort = Sort::bitonic;

  friend bool operator==(const ReplayHeader&, const ReplayHeader&) = default;
};

// What the last tick reported.
struct FinalReport {
  uint64_t score = 0;
  uint64_t kills = 0;
  uint32_t frameTime_us = 0;
  bool over = false;  // false: the run was left, or ran out of --ticks

  friend bool operator==(const FinalReport&, const FinalReport&) = default;
};

// The parts that a tick's hash is the sum of, by HashField.
using FieldHashes = std::array<uint64_t, kHashFields>;

struct Replay {
  ReplayHeader header;
  RuleTexts rules;
  std::vector<InputRecord> inputs;  // [0] is tick 1's
  std::vector<uint64_t> hashes;     // [0] is the state's after tick 1; as many as inputs
  // [k] is after tick kFieldHashesEvery_ticks * (k + 1). Empty in files before 2.0, and may end early in a partial one.
  std::vector<FieldHashes> fieldHashes;
  FinalReport result;
  bool whole = true;  // false: what there is of a file without its end; `result` is then not known

  uint32_t ticks() const { return uint32_t(inputs.size()); }
};

// What makes a simulation play it again: the embedded rules, and no autopilot, since the inputs already
// hold what it did. Throws TableError when the embedded rules are not this version's.
SimulationConfig replayConfig(const Replay& replay);

}  // namespace gw
