// Hash: every simulated field of every living entity and of the master, summed so that neither the NGrid's
// arrangement nor the order of visits is felt; where the arrangement is state, who stands in which cell; then the
// report, which is all the host gets to see.
//
// What is no state but must hold between ticks adds nothing to the sums as long as it does: that the dead stand at
// +infinity, that cells and ids name each other, that the tables are those that were uploaded. So damage to them is
// seen in the tick in which it happens, and not when something goes wrong because of it.
#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"
#include "gpu/math/bits.h"
#include "gpu/math/state_hash.h"

namespace gw::GW_DEVICE {
namespace {

GW_FN uint64_t pair(float a, float b) {
  return uint64_t(bitsOf(a)) << 32 | bitsOf(b);
}
GW_FN uint64_t pair(uint32_t a, uint32_t b) {
  return uint64_t(a) << 32 | b;
}

constexpr uint32_t kCellField = 0xCE11u;  // far above the fields of entities, whose owners are ids
constexpr uint32_t kDamageField = 0xDEADu;

// One team: a run of ids, whose hashes are added up field by field; sums of integers do not mind who adds first. By id,
// so that all but the cells is read in the order in which it lies.
struct HashEntities {
  static constexpr uint32_t kIds = 512;
  // Each lane has sums of its own, which cost a worker of the cpu device a quarter of the stage when they are 128.
  static constexpr uint32_t kLanes = GW_ON_CUDA ? 128 : 8;
  struct Shared {
    uint64_t sums[kHashFields][kLanes];
  };
  View v;
  bool withArrangement;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    const uint32_t begin = team.index * kIds, end = smaller(begin + kIds, v.capacity);
    team.phase([&](uint32_t lane) {
      uint64_t sums[kHashFields] = {};
      for (uint32_t id = begin + lane; id < end; id += kLanes) addId(id, sums);
      if (team.index == 0) sums[uint32_t(HashField::master)] = partOfTables(lane);
      for (uint32_t field = 0; field < kHashFields; ++field) s.sums[field][lane] = sums[field];
    });
    team.phase([&](uint32_t lane) {
      for (uint32_t field = lane; field < kHashFields; field += kLanes) {
        uint64_t sum = 0;
        for (uint32_t k = 0; k < kLanes; ++k) sum += s.sums[field][(k + lane) % kLanes];  // no two from one bank
        if (sum != 0) atomicAddTo64(v.scratch->fieldHashes[field], sum);
      }
    });
  }

 private:
  GW_BODY void addId(uint32_t id, uint64_t* sums) const {
    const uint32_t i = v.cellOf[id];
    const Cell cell = i < v.capacity ? v.moved[i] : Cell{0.0f, 0.0f, kNobody, kTypeNone};
    // The empty cells too: who is born there depends on it.
    if (withArrangement) sums[uint32_t(HashField::arrangement)] += hashWord(i, kCellField, id);
    if (cell.id != id) {  // with as many cells as ids: when each id's cell is its own, each cell's id is
      sums[uint32_t(HashField::arrangement)] += hashWord(i, kDamageField, cell.id);
      return;
    }
    if (cell.type != kTypeNone) return addEntity(cell, sums);
    if (cell.x != kInfinity || cell.y != kInfinity) {
      sums[uint32_t(HashField::place)] += hashWord(i, kDamageField, pair(cell.x, cell.y));
    }
  }

  // All lanes together 0 while the tables are as they were uploaded.
  GW_BODY uint64_t partOfTables(uint32_t lane) const {
    uint64_t sum = lane == 0 ? 0 - v.tables->checksum : 0;
    for (uint32_t w = lane; w < Tables::kWords; w += kLanes) sum += v.tables->wordHash(w);
    return sum;
  }

  GW_BODY void addEntity(const Cell& cell, uint64_t* sums) const {
    const uint32_t id = cell.id;
    const Float4 motion = v.velocityPrevious[id], force = v.nextForceEnergy[id], direction = v.nextDirectionMass[id];
    const Uint4 state = v.state[id];
    const Float2 push = v.push[id];
    const uint64_t words[] = {pair(cell.type, v.birthTick[id]), pair(cell.x, cell.y),   pair(motion.x, motion.y),
                              pair(motion.z, motion.w),         pair(force.x, force.y), pair(force.w, direction.z),
                              pair(direction.x, direction.y),   pair(push.x, push.y),   pair(state.x, state.y),
                              pair(state.z, state.w),           uint64_t(v.target[id])};
    static_assert(sizeof words / sizeof words[0] == kEntityHashFields, "in the order of HashField");
    WordHashes hashes(id);
    for (uint32_t field = 0; field < kEntityHashFields; ++field) sums[field] += hashes.next(words[field]);
  }
};

// One item in all.
struct Report {
  View v;

  GW_BODY void operator()(uint32_t) const {
    const Master& m = *v.master;
    TickScratch& s = *v.scratch;
    TickReport& report = *v.report;  // in place: as a local it would not fit the registers of a thread
    report = TickReport{};
    report.tick = m.tick;
    report.over = m.over != 0;
    report.ending = Ending(m.over);
    for (uint32_t field = 0; field < kHashFields; ++field) {
      const uint64_t sum = s.fieldHashes[field] + (field == uint32_t(HashField::master) ? masterHash(m) : 0);
      report.fieldHashes[field] = sum;
      report.hash += sum;
      s.fieldHashes[field] = 0;  // for the next tick to add up
    }
    report.input = s.input;
    report.ship_x = m.ship.x;
    report.ship_y = m.ship.y;
    report.shipPrevious_x = m.ship.previous_x;
    report.shipPrevious_y = m.ship.previous_y;
    report.aim_rad = m.ship.aim_rad;
    report.score = m.score;
    report.kills = m.kills;
    report.multiplierTenths = m.multiplierTenths;
    report.frameTime_us = m.frameTime_us;
    report.bank_us = m.bank_us;
    report.flushes = m.flushes;
    report.flush_x = m.flush_x;
    report.flush_y = m.flush_y;
    report.flushRadius_m = m.flushRadius_m;
    report.untouchable_ticks = m.ship.untouchable_ticks;
    report.clock_ticks = m.clock_ticks;
    report.wave = m.wave + m.endless;
    report.pace = m.pace;
    report.rowsWidened = v.near.ngrid.totals ? v.near.ngrid.widened() : 0.0f;
    for (uint32_t t = 0; t < kMaxEnemyTypes; ++t) {
      report.enemies += m.totals.occupied[t];
      report.killsByType[t] = m.killsByType[t];
    }
    report.enemies -= m.totals.dying;
    report.shots = m.totals.occupied[kTypeShot];
    report.bits = m.totals.occupied[kTypeBit];
    report.enemiesInView = m.totals.inView;
    report.idle_ticks = m.idle_ticks;
    report.peakEnemies = larger(m.peakEnemies, report.enemies);
    report.refused = m.refused;
    report.bitsTaken = m.bitsTaken;
    report.contacts = m.contacts;
    report.contactType = s.contactType;
    report.contactCost_us = s.contactCost_us;
    // Once the game is over the totals stand still: they were reported when they were new.
    const Totals fresh = m.over ? Totals{} : m.totals;
    report.edges = s.tally.edges;
    sounds(report, fresh, s);
    pops(report, m, s);
  }

 private:
  GW_BODY static uint64_t masterHash(const Master& m) {
    const uint32_t* words = reinterpret_cast<const uint32_t*>(&m);
    uint64_t sum = 0;
    for (uint32_t w = 0; w < sizeof(Master) / 4; w += 2) sum += hashWord(kNobody, w, pair(words[w], words[w + 1]));
    return sum;
  }

  GW_BODY static void sounds(TickReport& report, const Totals& totals, const TickScratch& s) {
    constexpr uint32_t kMiddle = 1;
    const auto put = [&](SoundEvent event, uint32_t pan, uint32_t count) {
      report.sounds[uint32_t(event)][pan] = uint16_t(smaller(count, 65535u));
    };
    put(SoundEvent::shot, kMiddle, s.shotSounds);
    put(SoundEvent::contact, kMiddle, s.contactSounds);
    put(SoundEvent::bit, kMiddle, totals.bitsTaken);
    put(SoundEvent::wave, kMiddle, s.waveSounds);
    put(SoundEvent::flush, kMiddle, s.flushSounds);
    put(SoundEvent::over, kMiddle, s.overSounds);
    for (uint32_t type = 0; type < kMaxEnemyTypes; ++type) {
      for (uint32_t pan = 0; pan < kPans; ++pan) {
        report.killSounds[type][pan] = uint16_t(smaller(s.tally.killSounds[type][pan], 65535u));
      }
    }
  }

  GW_BODY void pops(TickReport& report, const Master& m, const TickScratch& s) const {
    for (uint32_t side = 0; side < kPans; ++side) {
      if (s.pops[side] == 0) continue;
      const uint32_t id = ~uint32_t(s.pops[side]);
      if (v.cellOf[id] >= v.capacity) continue;  // damaged, which the hash tells
      const Cell cell = v.moved[v.cellOf[id]];
      const uint64_t value = s.pops[side] >> 32;
      const bool bare = (v.state[id].w & kFlagFlushed) != 0;
      const uint64_t points = bare ? value : value * m.multiplierTenths / 10;
      report.pops[side] = {cell.x, cell.y, uint32_t(points < 0xFFFFFFFFull ? points : 0xFFFFFFFFull)};
    }
  }
};

}  // namespace

void hash(Queue& queue, const View& view) {
  forEachTeam(queue, (view.capacity + HashEntities::kIds - 1) / HashEntities::kIds,
              HashEntities{view, isArrangementState(view.near.gather)});
  forEach(queue, Count{1}, Report{view});
}

}  // namespace gw::GW_DEVICE
