// Where two recorded runs part: what differs before the first tick, the first tick whose input differs, the first whose
// hash does, and which fields of the state differ then. Compares what is recorded; nothing is run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/replay/replay.h"

namespace gw {

struct NamedDifference {
  std::string name;  // of a header's field, or of a part of the result
  std::string a, b;
};

struct TableDifference {
  std::string file;   // "enemies.toml"
  uint32_t line = 0;  // the first that differs, from 1
  std::string a, b;   // the line; empty where a table has ended
};

struct InputDifference {
  uint32_t tick = 0;
  InputRecord a, b;
};

struct HashDifference {
  uint32_t tick = 0;
  uint64_t a = 0, b = 0;
};

struct FieldsDifference {
  uint32_t tick = 0;             // the first with hashes by field at or after the first tick whose hash differs
  std::vector<uint32_t> fields;  // HashField numbers; none: by then they were equal again
};

struct ReplayDiff {
  uint32_t ticks_a = 0, ticks_b = 0;
  bool whole_a = true, whole_b = true;
  std::vector<NamedDifference> header;  // whatever decides the game, and who played
  std::vector<TableDifference> tables;
  std::optional<InputDifference> input;  // both look at the ticks that both have
  std::optional<HashDifference> hash;
  std::optional<FieldsDifference> fields;  // none: both equal, or one file has none there
  std::vector<NamedDifference> result;     // of whole files

  // The command line is for people and differs between equal runs.
  bool same() const {
    return ticks_a == ticks_b && whole_a == whole_b && header.empty() && tables.empty() && !input && !hash &&
           result.empty();
  }
};

ReplayDiff diffReplays(const Replay& a, const Replay& b);

}  // namespace gw
