// Maintain: upkeep of what neighbours are found by. Of the NGrid each row anew, its members kept until a report says
// that rows have widened; or one pass per axis, or an odd and an even one, or all anew. Sorting groups the empty cells.
// Where the arrangement is state it stands still, like all state, once the game is over.
#include "game/sim/stages.h"

namespace gw::GW_DEVICE {

void maintain(Queue& queue, const View& view, Neighbourhood& neighbourhood) {
  neighbourhood.maintain(queue, view.cells, view.cellOf, &view.master->over);
}

}  // namespace gw::GW_DEVICE
