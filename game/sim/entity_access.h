// Entities between their record and the buffers that hold them, field by field as game/sim/entity_fields.h lists them.
#pragma once

#include "game/sim/state.h"

namespace gw::GW_DEVICE {

GW_FN EntityRecord recordOf(const EntityElements& elements) {
  EntityRecord e{};
  e.id = elements.cell.id;
#define GW_READ(member, Type, buffer, component, ...) e.member = elements.buffer component;
  GW_ENTITY_FIELDS(GW_READ)
#undef GW_READ
  return e;
}

GW_FN EntityElements elementsOf(const EntityRecord& e) {
  EntityElements elements{};
  elements.cell.id = e.id;
#define GW_WRITE(member, Type, buffer, component, ...) elements.buffer component = e.member;
  GW_ENTITY_FIELDS(GW_WRITE)
#undef GW_WRITE
  return elements;
}

// The entity in this cell of `moved`, as the stages of the tick have left it.
GW_FN EntityRecord entityAtEnd(const View& v, const Cell& moved) {
  EntityElements elements{};
  elements.cell = moved;
#define GW_ONE(name, Type) elements.name = v.name[moved.id];
#define GW_TWO(name, next, Type) elements.name = v.next[moved.id];
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO
  return recordOf(elements);
}

// Puts an entity into cell i, before think.
GW_FN void putEntity(const View& v, uint32_t i, const EntityRecord& e) {
  const EntityElements elements = elementsOf(e);
  v.cells[i] = elements.cell;
#define GW_ONE(name, Type) v.name[e.id] = elements.name;
#define GW_TWO(name, next, Type) v.name[e.id] = elements.name;
  GW_STATE_BUFFERS(GW_ONE, GW_TWO)
#undef GW_ONE
#undef GW_TWO
}

}  // namespace gw::GW_DEVICE
