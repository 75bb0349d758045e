// Maintain: NGrid upkeep. One pass per axis, or an odd and an even one; the empty cells are grouped by the sort, as
// in the thesis. Where the arrangement is state it stands still, like all state, once the game is over.
#include "game/sim/stages.h"

namespace gw::GW_DEVICE {

void maintain(Queue& queue, const View& view, NGrid& grid) {
  const uint32_t* d_hold = isArrangementState(view.gather) ? &view.master->over : nullptr;
  if (view.sort == Sort::oddEven) {
    grid.transpose(queue, view.cells, view.cellOf, d_hold);
  } else {
    grid.maintain(queue, view.cells, view.cellOf, d_hold);
  }
}

}  // namespace gw::GW_DEVICE
