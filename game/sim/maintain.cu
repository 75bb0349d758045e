// Maintain: upkeep of the structure that finds neighbours. The NGrid sorts each row and keeps its members until a
// report says that rows have widened; or makes one pass per axis, or an odd and an even one, or a full sort. Sorting
// groups the empty cells. Where the arrangement is state it does not change, like all state, once the game is over.
#include "game/sim/stages.h"

namespace gw::GW_DEVICE {

void maintain(Queue& queue, const View& view, Neighbourhood& neighbourhood) {
  neighbourhood.maintain(queue, view.cells, view.cellOf, &view.globals->over);
}

}  // namespace gw::GW_DEVICE
