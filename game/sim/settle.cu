// Settle: sums over all entities, for the next tick's logic and for the report.
#include <cstddef>

#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"

namespace gw::GW_DEVICE {
namespace {

constexpr uint32_t kCellsPerTeam = 1024;
constexpr float kMiddlePan_m = 6.0f;  // nearer than this to the ship's column sounds in the middle

// Totals after `contact`, as words: each team sums in shared memory and adds what is not zero.
constexpr uint32_t kFirstWord = offsetof(Totals, occupied) / 4, kWords = sizeof(Totals) / 4 - kFirstWord;
constexpr uint32_t kTallyWords = sizeof(Tally) / 4;

GW_FN constexpr uint32_t wordOf(size_t offset) {
  return uint32_t(offset / 4) - kFirstWord;
}
// The tally's words follow the totals'.
GW_FN constexpr uint32_t tallyWordOf(size_t offset) {
  return kWords + uint32_t(offset / 4);
}

// One team: a run of cells.
struct ReduceTotals {
  static constexpr uint32_t kLanes = 128;
  struct Shared {
    uint32_t words[kWords + kTallyWords];
  };
  View v;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    team.phase([&](uint32_t lane) {
      for (uint32_t w = lane; w < kWords + kTallyWords; w += kLanes) s.words[w] = 0;
    });
    const bool over = v.globals->over != 0;  // nothing changes after the end, the totals neither
    team.phase([&](uint32_t lane) {
      for (uint32_t k = lane; k < kCellsPerTeam && !over; k += kLanes) {
        const uint32_t i = team.index * kCellsPerTeam + k;
        if (i < v.capacity) add(s, i);
      }
    });
    team.phase([&](uint32_t lane) {
      uint32_t* totals = reinterpret_cast<uint32_t*>(&v.globals->totals) + kFirstWord;
      uint32_t* tally = reinterpret_cast<uint32_t*>(&v.scratch->tally);
      for (uint32_t w = lane; w < kWords + kTallyWords; w += kLanes) {
        if (s.words[w]) atomicAddTo(w < kWords ? totals[w] : tally[w - kWords], s.words[w]);
      }
    });
  }

 private:
  GW_BODY static void increment(Shared& s, uint32_t word) {
#if GW_ON_CUDA
    atomicAddTo(s.words[word], 1);
#else
    ++s.words[word];  // one thread runs all lanes of a team
#endif
  }

  GW_BODY void add(Shared& s, uint32_t i) const {
    const Cell before = v.cells[i], cell = v.moved[i];
    if (before.type == kTypeBit && (v.event[before.id] & kEventTaken))
      increment(s, wordOf(offsetof(Totals, bitsTaken)));
    if (cell.type == kTypeNone) return;
    increment(s, wordOf(offsetof(Totals, occupied)) + cell.type);
    if (isEnemy(cell.type)) enemy(s, cell);
  }

  GW_BODY void enemy(Shared& s, const Cell& cell) const {
    const Rules& r = v.tables->rules;
    const Ship& ship = v.globals->ship;
    const uint32_t event = v.event[cell.id];
    const Uint4 state = v.state[cell.id];
    const float dx = cell.x - ship.x, dy = cell.y - ship.y;
    if (event & kEventTransition) {
      const uint32_t from = event >> kEventFromShift, machine = uint32_t(r.enemies[cell.type].machine);
      increment(s, tallyWordOf(offsetof(Tally, edges)) + (machine * kStates + from) * kStates + state.x);
    }
    if (state.x == uint32_t(State::dead)) {
      increment(s, wordOf(offsetof(Totals, dying)));
      if (!(event & kEventDied)) return;
      const uint32_t side = dx < -kMiddlePan_m ? 0u : dx > kMiddlePan_m ? 2u : 1u;
      increment(s, tallyWordOf(offsetof(Tally, killSounds)) + 3 * cell.type + side);
      if (state.w & kFlagBlasted) return;
      atomicRaiseTo(v.scratch->pops[side], uint64_t(r.enemies[cell.type].value) << 32 | (~cell.id & 0xFFFFFFFFu));
      increment(s, wordOf(state.w & kFlagFlushed ? offsetof(Totals, bareKills) : offsetof(Totals, kills)) + cell.type);
      return;
    }
    if (magnitude(dx) <= r.idle.halfWidth_m && magnitude(dy) <= r.idle.halfHeight_m) {
      increment(s, wordOf(offsetof(Totals, inView)));
    }
    if (isAnnounced(v, cell.id) || state.x == uint32_t(State::attacking))
      increment(s, wordOf(offsetof(Totals, coming)));
  }
};

}  // namespace

void settle(Queue& queue, const View& view) {
  forEachTeam(queue, (view.capacity + kCellsPerTeam - 1) / kCellsPerTeam, ReduceTotals{view});
}

}  // namespace gw::GW_DEVICE
