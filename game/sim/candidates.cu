#include "game/sim/candidates.h"

namespace gw::GW_DEVICE {
namespace {

// One item: one cell. Entities in the high half's low bits, tests in the low 40.
template <class Search>
struct CountTests {
  uint64_t* tested;
  View v;
  Search search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell cell = v.moved[i];
    tested[i] = 0;
    if (!isEnemy(cell.type)) return;
    const uint32_t tests = search.around(i, cell.x, cell.y, v.tables->rules.enemies[cell.type].vision_m,
                                         [](const Cell&, uint32_t, float, float) {});
    tested[i] = 1ull << 40 | (tests - 1);
  }
};

}  // namespace

CandidateCount Candidates::run(Queue& queue, const View& view) {
  const Count all{view.capacity};
  if (view.broadPhase == BroadPhase::ngrid) {
    forEach(queue, all, CountTests<RowGather>{tested_.data(), view, RowGather{view.seenGrid}});
  } else {
    forEach(queue, all, CountTests<BruteForce>{tested_.data(), view, BruteForce{view.moved, view.capacity}});
  }
  sum_.run(queue, tested_.data(), total_.data());
  uint64_t total = 0;
  total_.download(&total, 1);
  return {total & ((1ull << 40) - 1), total >> 40};
}

}  // namespace gw::GW_DEVICE
