// Plays a run on two sides at once and, where they part, says where: tick, stage, field, entity, both values.
//
//   ticks    60 at a time, hash by hash; both keep a snapshot where they were equal last
//   tick     both go back to it and play to the tick before; then that tick stage by stage
//   stage    the first after which a field's hash differs
//   entity   the first block of 256 ids whose hash differs, and in it the first id whose value does
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "game/desync/probe.h"

namespace gw {

struct Desync {
  uint32_t tick = 0;
  std::array<uint64_t, 2> hashes{};  // [0] is this side's, [1] the reference's; so for all pairs

  // Empty when the two could not be made to part again, neither from the last snapshot nor from the start: then what
  // made them part is not in the state, or chance.
  std::string stage;
  // A side broke off while it was asked: what it said. All below but the tick and the hashes is then unknown.
  std::string unplaced{};
  // What differs after it, the first in the order of the table, entities before globals. Empty: all values are equal,
  // and only the hashes are not.
  std::string field;
  bool fromStart = false;        // parted again only when played from the start: snapshots do not hold the cause
  std::optional<uint32_t> id{};  // none: a global
  std::array<FieldValue, 2> values{};
  std::vector<std::string> fields{};                // all that differ after the stage, `field` the first
  uint32_t entities = 0;                            // in how many entities `field` differs
  std::array<std::vector<FieldValue>, 2> entity{};  // all of it, when it is one
  std::array<std::vector<NearEntity>, 2> around{};
};

struct Lockstep {
  std::vector<uint64_t> hashes;  // of this side: of all ticks that were played, the one in which they part the last
  std::optional<Desync> desync{};
  bool interrupted = false;
};

// `goOn` is asked every second of play, with the ticks played so far.
Lockstep playInLockstep(Probe& own, Probe& reference, uint32_t ticks, const std::function<bool(uint32_t)>& goOn);

}  // namespace gw
