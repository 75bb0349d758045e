#include <algorithm>

#include "game/sim/queries/census.h"

namespace gw::GW_DEVICE {
namespace {

constexpr uint32_t kCounts = CensusTaker::kCounts, kSearched = kTypeCount;

// One item: one count.
struct ClearCounts {
  uint32_t* counts;
  GW_BODY void operator()(uint32_t i) const { counts[i] = 0; }
};

// One team: a run of cells.
struct CountCells {
  static constexpr uint32_t kLanes = 64, kCellsPerTeam = 1024;
  struct Shared {
    uint32_t lane[kLanes][kCounts];
  };
  uint32_t* counts;
  View v;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    team.phase([&](uint32_t lane) {
      uint32_t* mine = s.lane[lane];
      for (uint32_t c = 0; c < kCounts; ++c) mine[c] = 0;
      for (uint32_t k = lane; k < kCellsPerTeam; k += kLanes) {
        const uint32_t i = team.index * kCellsPerTeam + k;
        if (i >= v.capacity) continue;
        const Cell cell = v.cells[i];
        if (v.moved[i].type != kTypeNone) ++mine[kSearched];
        if (cell.type != kTypeNone && !isDying(cell)) ++mine[cell.type];
      }
    });
    team.phase([&](uint32_t lane) {
      for (uint32_t c = lane; c < kCounts; c += kLanes) {
        uint32_t sum = 0;
        for (uint32_t l = 0; l < kLanes; ++l) sum += s.lane[l][c];
        if (sum != 0) atomicAddTo(counts[c], sum);
      }
    });
  }

 private:
  GW_BODY bool isDying(const Cell& cell) const {
    return isEnemy(cell.type) && v.state[cell.id].x == uint32_t(State::dead);
  }
};

}  // namespace

Census CensusTaker::run(Queue& queue, const View& view, Neighbourhood& neighbourhood) {
  forEach(queue, Count{kCounts}, ClearCounts{counts_.data()});
  const uint32_t teams = (view.capacity + CountCells::kCellsPerTeam - 1) / CountCells::kCellsPerTeam;
  forEachTeam(queue, teams, CountCells{counts_.data(), view});
  uint32_t counts[kCounts];
  counts_.download(counts, kCounts);
  Census census;
  std::copy_n(counts, kMaxEnemyTypes, census.enemies);
  census.shots = counts[kTypeShot];
  census.bits = counts[kTypeBit];
  census.searched = counts[kSearched];
  census.misaligned = neighbourhood.misaligned(queue, view.moved);
  return census;
}

}  // namespace gw::GW_DEVICE
