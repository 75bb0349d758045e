// All entities on the host: copies of the buffers of state, for snapshots, the state dump and tests.
#pragma once

#include <vector>

#include "game/sim/entity_access.h"

namespace gw::GW_DEVICE {

// Of buffers that alternate: the start of the view's tick, or what the tick writes.
enum class Side { start, end };

struct EntityCopies {
  std::vector<Cell> cells;
  std::vector<uint32_t> cellOf;
#define GW_ONE(name, Type) std::vector<Type> name;
#define GW_TWO(name, next, Type) std::vector<Type> name;
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO

  EntityCopies(const GameState& game, const View& v, Side ofCells, Side ofOthers)
      : cells(sideOf(game.cells, ofCells == Side::start ? v.cells : v.moved).download()),
        cellOf(game.cellOf.download()) {
#define GW_ONE(name, Type) name = game.name.download();
#define GW_TWO(name, next, Type) name = sideOf(game.name, ofOthers == Side::start ? v.name : v.next).download();
    GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO
  }

  // Of a type that is kTypeNone where no entity lives, and where damage has left an id without a cell.
  EntityRecord at(uint32_t id) const {
    EntityElements elements{};
    elements.cell = cellOf[id] < cells.size() ? cells[cellOf[id]] : Cell{kInfinity, kInfinity, id, kTypeNone};
#define GW_ONE(name, Type) elements.name = name[id];
#define GW_TWO(name, next, Type) elements.name = name[id];
    GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO
    return recordOf(elements);
  }
};

// Writes these entities, and nothing for all other ids, at the start of the view's tick; the cells are the caller's.
inline void uploadEntities(GameState& game, const View& v, const std::vector<EntityRecord>& entities) {
#define GW_ONE(name, Type) std::vector<Type> name(v.capacity);
#define GW_TWO(name, next, Type) std::vector<Type> name(v.capacity);
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO
  for (const EntityRecord& e : entities) {
    const EntityElements elements = elementsOf(e);
#define GW_ONE(name, Type) name[e.id] = elements.name;
#define GW_TWO(name, next, Type) name[e.id] = elements.name;
    GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO
  }
#define GW_ONE(name, Type) game.name.upload(name);
#define GW_TWO(name, next, Type) sideOf(game.name, v.name).upload(name);
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO
}

}  // namespace gw::GW_DEVICE
