// Maintain: NGrid upkeep. One pass per axis; the empty cells are grouped by the sort, as in the thesis.
#include "game/sim/stages.h"

namespace gw::GW_DEVICE {

void maintain(Queue& queue, const View& view, NGrid& grid) {
  grid.maintain(queue, view.cells, view.cellOf);
}

}  // namespace gw::GW_DEVICE
