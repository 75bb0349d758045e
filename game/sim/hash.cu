// Hash: every simulated field of every living entity, summed so that neither the NGrid's arrangement nor the order of
// visits has an influence; where the arrangement is state, which id stands in which cell. Report adds the globals.
//
// Invariants between ticks that are no state add nothing to the sums as long as they hold: that the dead are at
// +infinity, that cells and ids name each other, that the tables are those that were uploaded. So damage to them is
// seen in the tick in which it happens, and not when something goes wrong because of it.
#include "game/sim/entity_access.h"
#include "game/sim/stages.h"
#include "gpu/math/bits.h"
#include "gpu/math/state_hash.h"

namespace gw::GW_DEVICE {
namespace {

GW_FN uint64_t pair(float a, float b) {
  return uint64_t(bitsOf(a)) << 32 | bitsOf(b);
}
// The bits of a field, whatever its type.
GW_FN uint32_t fieldBits(float value) {
  return bitsOf(value);
}
GW_FN uint32_t fieldBits(uint32_t value) {
  return value;
}

constexpr uint32_t kCellField = 0xCE11u;  // far above the fields of entities, whose owners are ids
constexpr uint32_t kDamageField = 0xDEADu;

// One team: a run of ids, whose hashes are added up field by field; sums of integers do not depend on the order. By id,
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
      if (team.index == 0) sums[uint32_t(HashField::globals)] = partOfTables(lane);
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
    // The empty cells too: they decide which entity is born there.
    if (withArrangement) sums[uint32_t(HashField::arrangement)] += hashWord(i, kCellField, id);
    if (cell.id != id) {  // with as many cells as ids: when each id's cell is its own, each cell's id is
      sums[uint32_t(HashField::arrangement)] += hashWord(i, kDamageField, cell.id);
      return;
    }
    if (cell.type != kTypeNone) return addEntity(cell, sums);
    if (cell.x != kInfinity || cell.y != kInfinity) {
      sums[uint32_t(HashField::position)] += hashWord(i, kDamageField, pair(cell.x, cell.y));
    }
  }

  // All lanes together 0 while the tables are as they were uploaded.
  GW_BODY uint64_t partOfTables(uint32_t lane) const {
    uint64_t sum = lane == 0 ? 0 - v.tables->checksum : 0;
    for (uint32_t w = lane; w < Tables::kWords; w += kLanes) sum += v.tables->wordHash(w);
    return sum;
  }

  GW_BODY void addEntity(const Cell& cell, uint64_t* sums) const {
    const EntityRecord e = entityAtEnd(v, cell);
    uint64_t words[kEntityHashFields] = {};
#define GW_ADD(member, Type, buffer, component, column, word, half) \
  words[uint32_t(word)] |= uint64_t(fieldBits(e.member)) << half;
    GW_ENTITY_FIELDS(GW_ADD)
#undef GW_ADD
    WordHashes hashes(cell.id);
    for (uint32_t field = 0; field < kEntityHashFields; ++field) sums[field] += hashes.next(words[field]);
  }
};

}  // namespace

void hash(Queue& queue, const View& view) {
  forEachTeam(queue, (view.capacity + HashEntities::kIds - 1) / HashEntities::kIds,
              HashEntities{view, isArrangementState(view.near.gather)});
}

}  // namespace gw::GW_DEVICE
