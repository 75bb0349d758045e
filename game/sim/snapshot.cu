#include <cmath>
#include <cstring>
#include <stdexcept>

#include "game/sim/entity_copies.h"
#include "game/sim/snapshot.h"

namespace gw::GW_DEVICE {
namespace {

// One item: one id. Puts its cell of the next tick's start where the NGrid has just arranged it.
struct PlaceById {
  Cell* cells;
  const uint32_t* cellOf;
  const Cell* byId;
  GW_BODY void operator()(uint32_t id) const { cells[cellOf[id]] = byId[id]; }
};

// One item: one cell. Fills it with its id of the arrangement.
struct FillByArrangement {
  Cell* cells;
  uint32_t* cellOf;
  const uint32_t* arrangement;
  const Cell* byId;
  GW_BODY void operator()(uint32_t i) const {
    cells[i] = byId[arrangement[i]];
    cellOf[arrangement[i]] = i;
  }
};

void checkArrangement(const std::vector<uint32_t>& arrangement, uint32_t capacity) {
  std::vector<bool> seen(capacity);
  bool whole = arrangement.size() == capacity;
  for (size_t i = 0; whole && i < arrangement.size(); ++i) {
    whole = arrangement[i] < capacity && !seen[arrangement[i]];
    if (whole) seen[arrangement[i]] = true;
  }
  if (!whole) {
    throw std::invalid_argument(
        "The snapshot's arrangement of cells does not fit; restore it with the capacity it was taken with.");
  }
}

// What kernels would follow without looking: an id, a type, a state, a place.
void checkSnapshot(const Snapshot& snapshot, const Tables& tables, Gather gather) {
  const uint32_t capacity = tables.limits.capacity;
  if (isArrangementState(gather) && !snapshot.arrangement.empty()) checkArrangement(snapshot.arrangement, capacity);
  if (snapshot.globals.size() != sizeof(GameGlobals)) {
    throw std::invalid_argument("The snapshot was made by another version of the game; take a new one.");
  }
  for (size_t i = 0; i < snapshot.entities.size(); ++i) {
    const EntityRecord& e = snapshot.entities[i];
    if (e.id >= capacity || (i > 0 && e.id <= snapshot.entities[i - 1].id)) {
      throw std::invalid_argument(
          "The snapshot's entities do not fit; restore it with the capacity it was taken with.");
    }
    const bool enemy = isEnemy(e.type);
    if (e.type >= kTypeCount || (enemy && e.type >= tables.rules.enemyTypeCount)) {
      throw std::invalid_argument(
          "The snapshot holds an entity of no known type; restore it with the rules it was taken with.");
    }
    if (enemy && e.state >= uint32_t(State::count)) {
      throw std::invalid_argument("The snapshot holds an enemy in no known state; take a new one.");
    }
    if (!std::isfinite(e.x) || !std::isfinite(e.y) || !std::isfinite(e.previous_x) || !std::isfinite(e.previous_y)) {
      throw std::invalid_argument("The snapshot holds an entity that is nowhere; take a new one.");
    }
  }
}

}  // namespace

Snapshot takeSnapshot(const GameState& state, const View& next) {
  Snapshot snapshot;
  snapshot.globals.resize(sizeof(GameGlobals));
  GameGlobals globals;
  state.globals.download(&globals, 1);
  std::memcpy(snapshot.globals.data(), &globals, sizeof globals);

  const EntityCopies copies(state, next, Side::start, Side::start);
  if (isArrangementState(next.near.gather)) {
    for (const Cell& cell : copies.cells) snapshot.arrangement.push_back(cell.id);
  }
  for (uint32_t id = 0; id < next.capacity; ++id) {
    const EntityRecord e = copies.at(id);
    if (e.type != kTypeNone) snapshot.entities.push_back(e);
  }
  return snapshot;
}

void restoreSnapshot(Queue& queue, GameState& state, const View& next, const Snapshot& snapshot) {
  Tables tables;
  state.tables.download(&tables, 1);
  checkSnapshot(snapshot, tables, state.neighbourhood().gather());
  const uint32_t n = next.capacity;
  std::vector<Cell> now(n), before(n);
  for (uint32_t id = 0; id < n; ++id) now[id] = before[id] = {kInfinity, kInfinity, id, kTypeNone};
  for (const EntityRecord& e : snapshot.entities) {
    now[e.id] = {e.x, e.y, e.id, e.type};
    before[e.id] = {e.previous_x, e.previous_y, e.id, e.type};
  }
  const int side = state.cells[0].data() == next.cells ? 0 : 1;
  GameGlobals globals;
  std::memcpy(&globals, snapshot.globals.data(), sizeof globals);
  state.globals.upload(&globals, 1);
  uploadEntities(state, next, snapshot.entities);

  // Neighbours are found over the start of the last tick, as maintain left it; the end of that tick then
  // stands in the same arrangement.
  Cell* d_before = state.cells[1 - side].data();
  Buffer<Cell> byId(queue, n);
  if (isArrangementState(state.neighbourhood().gather())) {
    const bool known = !snapshot.arrangement.empty();
    const auto arrangement = known ? snapshot.arrangement : startArrangement(state.neighbourhood().dimensions());
    Buffer<uint32_t> d_arrangement(queue, n);
    d_arrangement.upload(arrangement);
    byId.upload(before);
    forEach(queue, Count{n}, FillByArrangement{d_before, state.cellOf.data(), d_arrangement.data(), byId.data()});
    if (!known) state.neighbourhood().arrange(queue, d_before, state.cellOf.data());
    queue.synchronise();  // the sources of these copies end here
  } else {
    state.cells[1 - side].upload(before);
    state.neighbourhood().arrange(queue, d_before, state.cellOf.data());
  }
  byId.upload(now);
  forEach(queue, Count{n}, PlaceById{state.cells[side].data(), state.cellOf.data(), byId.data()});
  queue.synchronise();
}

}  // namespace gw::GW_DEVICE
