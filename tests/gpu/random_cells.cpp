#include "tests/gpu/random_cells.h"

#include <cmath>
#include <limits>

namespace gw::test {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

Float2 placeIn(Layout layout, std::mt19937_64& random) {
  const auto any = [&](float low, float high) { return between(random, low, high); };
  switch (layout) {
    case Layout::uniform:
      return {any(0, 100), any(0, 100)};
    case Layout::clustered: {
      const float heap = float(random() % 8);
      return {heap * 11 + any(-1, 1) * any(0, 1), heap * heap * 1.5f + any(-1, 1) * any(0, 1)};
    }
    case Layout::line:
      return {any(0, 100), 42.0f};
    case Layout::coincident:
      return {float(random() % 3) * 0.1f, float(random() % 3) * 0.1f};
    case Layout::lattice:
      return {float(random() % 24), float(random() % 24)};
    case Layout::huge:
      return {any(-1, 1) * 1e30f, any(-1, 1) * 1e30f};
    case Layout::nearOrigin:
      return {any(-1, 1), any(-1, 1)};
    case Layout::zeros: {
      const float values[] = {0.0f, -0.0f, 1e-45f, -1e-45f, 1e-38f, -1e-38f, 1e-20f};
      return {values[random() % 7], values[random() % 7]};
    }
  }
  return {0, 0};
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const CellSpec& spec) {
  return out << "layout " << uint32_t(spec.layout) << ", " << spec.shape.columns << " x " << spec.shape.rows << " x "
             << spec.shape.slabs << ", " << spec.deadPercent << "% dead, seed " << spec.seed;
}

float between(std::mt19937_64& random, float low, float high) {
  return low + (high - low) * (float(random() >> 40) * 0x1p-24f);
}

std::vector<Cell> makeCells(const CellSpec& spec) {
  std::mt19937_64 random(spec.seed);
  std::vector<Cell> cells;
  for (uint32_t id = 0; id < spec.shape.cells(); ++id) {
    const Float2 at = placeIn(spec.layout, random);
    const bool dead = random() % 100 < spec.deadPercent;
    cells.push_back({dead ? kInfinite : at.x, dead ? kInfinite : at.y, id, 7 * id + 1});
  }
  return cells;
}

std::vector<Cell3> makeCells3(const CellSpec& spec) {
  CellSpec heights = spec;
  heights.seed = ~spec.seed;
  heights.deadPercent = 0;
  const std::vector<Cell> flat = makeCells(spec), high = makeCells(heights);
  std::vector<Cell3> cells;
  for (size_t i = 0; i < flat.size(); ++i) {
    const bool dead = flat[i].x == kInfinite;
    cells.push_back({flat[i].x, flat[i].y, dead ? kInfinite : high[i].x, flat[i].id});
  }
  return cells;
}

namespace {

float* heightOf(Cell&) {
  return nullptr;
}
float* heightOf(Cell3& cell) {
  return &cell.z;
}

template <class CellT>
void moveAll(std::vector<CellT>& cells, float step, uint64_t seed) {
  std::mt19937_64 random(seed);
  for (CellT& cell : cells) {
    const bool dead = cell.x == kInfinite;
    const uint64_t fate = random() % 64;
    for (float* place : {&cell.x, &cell.y, heightOf(cell)}) {
      if (!place) continue;
      if (!dead) *place += between(random, -step, step);
      if (!dead && fate == 0) *place = kInfinite;
      if (dead && fate == 1) *place = between(random, 0, 100);
    }
  }
}

}  // namespace

void moveCells(std::vector<Cell>& cells, float step, uint64_t seed) {
  moveAll(cells, step, seed);
}
void moveCells(std::vector<Cell3>& cells, float step, uint64_t seed) {
  moveAll(cells, step, seed);
}

std::vector<Query> makeQueries(const std::vector<Cell>& cells, uint32_t count, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Cell> living;
  for (const Cell& cell : cells) {
    if (cell.x < kInfinite) living.push_back(cell);
  }
  if (living.empty()) living.push_back({1.0f, 2.0f, 0, 0});
  const auto any = [&]() -> const Cell& { return living[random() % living.size()]; };
  std::vector<Query> queries;
  for (uint32_t q = 0; q < count; ++q) {
    const Cell &from = any(), &to = any();
    const float across = std::fabs(to.x - from.x), along = std::fabs(to.y - from.y);
    Query query{from.x, from.y, 1.0f};
    switch (q % 8) {
      case 0:
        query = {from.x, to.y, across};
        break;  // `to` exactly right or left on the boundary
      case 1:
        query = {to.x, from.y, along};
        break;  // exactly above or below
      case 2:
        query.radius = across < along ? along : across;
        break;
      case 3:
        query.radius = std::ldexp(1.0f, int(random() % 16) - 10);
        break;
      case 4:
        query = {to.x + 0.5f, from.y - 0.25f, (across + along) / 8};
        break;
      case 5:
        query.radius = std::ldexp(1.0f, int(random() % 240) - 120);
        break;
      case 6:
        query.radius = 0.0f;
        break;
      case 7:
        query.radius = kInfinite;
        break;
    }
    queries.push_back(query);
  }
  return queries;
}

std::vector<Query3> makeQueries3(const std::vector<Cell3>& cells, uint32_t count, uint64_t seed) {
  // Boundaries along each pair of axes come from the flat queries of that pair.
  std::vector<Query3> queries;
  std::vector<Cell> flat;
  std::mt19937_64 random(seed);
  for (uint32_t turn = 0; turn < 3; ++turn) {
    flat.clear();
    for (const Cell3& cell : cells) {
      const float axes[3] = {cell.x, cell.y, cell.z};
      flat.push_back({axes[turn], axes[(turn + 1) % 3], cell.id, 0});
    }
    for (const Query& query : makeQueries(flat, (count + 2 - turn) / 3, seed + turn)) {
      float axes[3];
      axes[turn] = query.x;
      axes[(turn + 1) % 3] = query.y;
      const Cell3& third = cells[random() % cells.size()];
      const float thirds[3] = {third.x, third.y, third.z};
      const float height = thirds[(turn + 2) % 3];
      axes[(turn + 2) % 3] = height < kInfinite ? height : 0.5f;
      queries.push_back({axes[0], axes[1], axes[2], query.radius});
    }
  }
  return queries;
}

Words makeWords(size_t count, uint64_t seed) {
  std::mt19937_64 random(seed);
  Words words;
  for (size_t i = 0; i < count; ++i) {
    const uint64_t kind = random() % 4, value = random();
    words.push_back(kind == 0 ? 0 : kind == 1 ? 1 : kind == 2 ? value % 100 : value);
  }
  return words;
}

}  // namespace gw::test
