#include "game/sim/queries/candidates.h"
#include "gpu/exec/stage_timer.h"

namespace gw::GW_DEVICE {
namespace {

// One item: one cell. Entities in the high half's low bits, tests in the low 40.
template <class Search>
struct CountTests {
  uint64_t *tested, *found;
  View v;
  Search search;

  GW_BODY void operator()(uint32_t i) const {
    const Cell cell = v.moved[i];
    tested[i] = found[i] = 0;
    if (!isEnemy(cell.type)) return;
    uint32_t neighbours = 0;
    const uint32_t tests = search.around(i, placeOf(cell), v.tables->rules.enemies[cell.type].vision_m,
                                         [&](const Cell&, uint32_t, Float2) { ++neighbours; });
    tested[i] = 1ull << 40 | (tests - 1);
    found[i] = neighbours - 1;
  }
};

}  // namespace

CandidateCount Candidates::run(Queue& queue, const View& view) {
  const double search_ms = timeAlone_ms(queue, [&] {
    withSearch(view.seen, [&](auto search) {
      forEach(queue, Count{view.capacity}, CountTests<decltype(search)>{tested_.data(), found_.data(), view, search});
    });
  });
  const uint64_t tests = sumOf(queue, tested_);
  return {tests & ((1ull << 40) - 1), sumOf(queue, found_), tests >> 40, search_ms};
}

uint64_t Candidates::sumOf(Queue& queue, const Buffer<uint64_t>& words) {
  sum_.run(queue, words.data(), total_.data());
  uint64_t total = 0;
  total_.download(&total, 1);
  return total;
}

}  // namespace gw::GW_DEVICE
