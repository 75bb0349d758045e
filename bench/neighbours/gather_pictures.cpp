// ngrid_gather_*.png: what a search around one entity looks at, finds and misses.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>

#include "bench/neighbours/pictures.h"
#include "gpu/neighbours/brute_force.h"
#include "gpu/neighbours/uniform_grid.h"
#include "gpu/ngrid/row_gather.h"
#include "gpu/ngrid/window_gather.h"

namespace gw::bench {
namespace {

using namespace gw::cpu;

constexpr float kRadius_px = 60.0f;
// Told apart by the colour blind as well; shapes differ too.
constexpr Colour kFound{0.0f, 0.45f, 0.70f}, kTested{0.90f, 0.62f, 0.0f}, kMissed{0.80f, 0.15f, 0.10f};
constexpr Colour kLooked{1.0f, 0.92f, 0.74f};  // where

// What one search did.
struct Search {
  std::vector<Cell> tested;
  std::vector<uint32_t> found;  // ids
  uint32_t tests;               // as it said itself
};

void drawGather(const std::string& path, const TextFont& font, const Crowd<Cell>& crowd, const Cell& asker,
                const Search& search, const std::string& title,
                const std::function<void(Canvas&, const Look&)>& under) {
  if (search.tests != search.tested.size()) {
    throw std::logic_error(title + ": " + std::to_string(search.tests) + " tests, " +
                           std::to_string(search.tested.size()) + " are drawn");
  }
  Canvas canvas(kSize, font, kGround);
  const Look look{{asker.x, asker.y}, kRadius_px / crowd.radius};
  under(canvas, look);
  canvas.ring(look(asker), kRadius_px, 1.6f, kInk);
  std::vector<bool> tested(crowd.byId.size()), found(crowd.byId.size());
  for (const Cell& cell : search.tested) tested[cell.id] = true;
  for (const uint32_t id : search.found) found[id] = true;
  uint32_t counts[3] = {};
  for (const Cell& cell : crowd.byId) {
    if (cell.id == asker.id) continue;
    const Float2 at = look(cell);
    if (found[cell.id]) {
      canvas.disc(at, 5.0f, kFound);
      ++counts[0];
    } else if (isNeighbour(placeOf(cell) - placeOf(asker), crowd.radius)) {
      canvas.cross(at, 5.5f, 3.0f, kMissed);
      ++counts[1];
    } else if (tested[cell.id]) {
      canvas.square(at, 3.6f, 1.6f, kTested);
      ++counts[2];
    } else {
      canvas.disc(at, 2.0f, kPale);
    }
  }
  canvas.disc(look(asker), 7.0f, kInk);
  canvas.disc(look(asker), 3.0f, kGround);
  drawBars(canvas, title);
  const float y = float(kSize.height) - 8.0f, middle = y - 4.5f;
  float x = 8.0f;
  const auto entry = [&](const auto& draw, const std::string& text) {
    draw(Float2{x + 6.0f, middle});
    x = canvas.text({x + 20.0f, y}, 9, text, kInk) + 14.0f;
  };
  entry([&](Float2 at) { canvas.disc(at, 5.0f, kFound); }, std::to_string(counts[0]) + " found");
  entry([&](Float2 at) { canvas.square(at, 3.6f, 1.6f, kTested); }, std::to_string(counts[2]) + " tested in vain");
  entry([&](Float2 at) { canvas.cross(at, 5.5f, 3.0f, kMissed); }, std::to_string(counts[1]) + " missed");
  entry([&](Float2 at) { canvas.disc(at, 2.0f, kPale); }, "not looked at");
  std::printf("%s: %s: %u found, %u tested in vain, %u missed\n", path.c_str(), title.c_str(), counts[0], counts[2],
              counts[1]);
  canvas.save(path);
}

// Device memory may be followed by what is launched only.
template <class Body>
void launch(Queue& queue, const Body& body) {
  forEach(queue, Count{1}, [&](uint32_t) { body(); });
}

template <class Gather>
void ask(const Gather& gather, uint32_t index, const Cell& asker, float radius, Search& search) {
  search.tests = gather.around(index, placeOf(asker), radius,
                               [&](const Cell& cell, uint32_t, Float2) { search.found.push_back(cell.id); });
}

struct Span {
  uint32_t begin, end;
};

// Searches test up to three cells more, so that they come in fours, where there are so many.
Span inFours(uint32_t begin, uint32_t end, uint32_t last) {
  return {begin, std::min(begin + ((end - begin + 3) & ~3u), last)};
}

// The columns of a row of a packed grid that a search tests, as RowGather describes it.
Span spanOf(const NGridView<Cell>& view, uint32_t row, const Cell& asker, float radius) {
  const float rounding = (magnitude(asker.x) + radius) * 0x1p-20f;
  const auto part = [&](float x) { return partOf(view.totals->parts, view.parts, x); };
  const uint16_t* first = view.firstColumn + row * (view.parts + 1);
  return inFours(first[part(asker.x - radius - rounding)], first[part(asker.x + radius + rounding) + 1],
                 first[view.parts]);
}

struct Picture {
  const TextFont& font;
  const Crowd<Cell>& crowd;
  Float3 box() const { return {crowd.world[0], crowd.world[1], 0.0f}; }
  uint32_t n() const { return uint32_t(crowd.byId.size()); }
};

void drawRows(const std::string& path, const Picture& of, const Cell& asker) {
  const float r = of.crowd.radius;
  KeptGrid kept(of.crowd.byId, chooseDimensions(of.n(), of.box(), r), Kept::packed);
  kept.grid.rebuild(kept.queue, kept.cells.data(), kept.cellOf.data());
  Search search{};
  std::vector<Interval> met;
  launch(kept.queue, [&] {
    const NGridView<Cell> view = kept.grid.view(kept.cells.data());
    const RowGather<Cell> gather{view};
    ask(gather, kept.cellOf.data()[asker.id], asker, r, search);
    for (uint32_t row = 0; row < view.rows; ++row) {
      const Interval y = view.height[row];
      if (y.low - asker.y > r || asker.y - y.high > r) continue;
      met.push_back(y);
      const Span span = spanOf(view, row, asker, r);
      const Cell* line = view.cells + row * view.columns;
      search.tested.insert(search.tested.end(), line + span.begin, line + span.end);
    }
  });
  drawGather(path, of.font, of.crowd, asker, search, "exact: rows that meet the circle, in each a span of x",
             [&](Canvas& canvas, const Look& look) {
               for (const Interval& row : met) {
                 canvas.rectangle({0, look(0, row.high).y + 1.0f}, {float(kSize.width), look(0, row.low).y - 1.0f},
                                  kLooked, 0.45f);
                 canvas.rectangle({look(asker.x - r, 0).x, look(0, row.high).y + 1.0f},
                                  {look(asker.x + r, 0).x, look(0, row.low).y - 1.0f}, kLooked);
               }
             });
}

void drawBins(const std::string& path, const Picture& of, const Cell& asker) {
  const float r = of.crowd.radius;
  Queue queue{ExecOptions{1}};
  UniformGrid<Cell> grid(queue, of.n(),
                         binsOver(Float2{0, 0}, Float2{of.crowd.world[0], of.crowd.world[1]}, r, of.n()));
  Buffer<Cell> cells(queue, of.n());
  Buffer<uint32_t> cellOf(queue, of.n());
  cells.upload(of.crowd.byId);
  grid.maintain(queue, cells.data(), cellOf.data());
  Search search{};
  Bins bins{};
  launch(queue, [&] {
    const GridGather<Cell> gather = grid.view(cells.data());
    bins = gather.bins;
    ask(gather, cellOf.data()[asker.id], asker, r, search);
    for (uint32_t y = bins.first(1, asker.y, r); y <= bins.last(1, asker.y, r); ++y) {
      const uint32_t* begin = gather.begin + y * bins.count[0];
      const Span run =
          inFours(begin[bins.first(0, asker.x, r)], begin[bins.last(0, asker.x, r) + 1], begin[bins.count[0]]);
      search.tested.insert(search.tested.end(), gather.cells + run.begin, gather.cells + run.end);
    }
  });
  drawGather(path, of.font, of.crowd, asker, search, "uniform grid: all bins that meet the circle's box",
             [&](Canvas& canvas, const Look& look) {
               const auto edge = [&](int axis, uint32_t bin) { return bins.low[axis] + float(bin) / bins.perMetre; };
               for (uint32_t y = bins.first(1, asker.y, r); y <= bins.last(1, asker.y, r); ++y) {
                 for (uint32_t x = bins.first(0, asker.x, r); x <= bins.last(0, asker.x, r); ++x) {
                   const Float2 low = look(edge(0, x), edge(1, y + 1)), high = look(edge(0, x + 1), edge(1, y));
                   canvas.rectangle({low.x + 1.0f, low.y + 1.0f}, {high.x - 1.0f, high.y - 1.0f}, kLooked);
                 }
               }
             });
}

// The window of an adaptive search, as AdaptiveGather describes it.
Window adaptiveWindow(const NGridView<Cell>& view, uint32_t index, const Cell& asker, float radius) {
  const uint32_t column = index % view.columns, row = index / view.columns;
  const auto at = [&](uint32_t r, uint32_t c) { return view.cells[r * view.columns + c]; };
  const auto byX = [&](const Cell& cell) { return magnitude(cell.x - asker.x) <= radius; };
  const auto byY = [&](const Cell& cell) { return magnitude(cell.y - asker.y) <= radius; };
  Window w{column, column, row, row, 0, 0};
  while (w.firstColumn > 0 && byX(at(row, w.firstColumn - 1))) --w.firstColumn;
  while (w.lastColumn + 1 < view.columns && byX(at(row, w.lastColumn + 1))) ++w.lastColumn;
  while (w.firstRow > 0 && byY(at(w.firstRow - 1, column))) --w.firstRow;
  while (w.lastRow + 1 < view.rows && byY(at(w.lastRow + 1, column))) ++w.lastRow;
  return w;
}

Window fixedWindow(const NGridView<Cell>& view, uint32_t index, uint32_t cells) {
  const uint32_t column = index % view.columns, row = index / view.columns;
  return {column - smaller(column, cells),
          smaller(column + cells, view.columns - 1),
          row - smaller(row, cells),
          smaller(row + cells, view.rows - 1),
          0,
          0};
}

void drawWindow(const std::string& path, const Picture& of, KeptGrid& kept, const Cell& asker, bool adaptive) {
  const float r = of.crowd.radius;
  Search search{};
  std::vector<std::pair<Cell, Cell>> net;  // neighbours on a line, both in the window
  launch(kept.queue, [&] {
    const NGridView<Cell> view = kept.grid.view(kept.cells.data());
    const uint32_t index = kept.cellOf.data()[asker.id];
    if (adaptive) {
      ask(AdaptiveGather<Cell>{view}, index, asker, r, search);
    } else {
      ask(FixedGather<Cell>{view}, index, asker, r, search);
    }
    const Window w = adaptive ? adaptiveWindow(view, index, asker, r) : fixedWindow(view, index, NRadius{}.x);
    for (uint32_t row = w.firstRow; row <= w.lastRow; ++row) {
      for (uint32_t column = w.firstColumn; column <= w.lastColumn; ++column) {
        const uint32_t i = row * view.columns + column;
        search.tested.push_back(view.cells[i]);
        if (column < w.lastColumn) net.push_back({view.cells[i], view.cells[i + 1]});
        if (row < w.lastRow) net.push_back({view.cells[i], view.cells[i + view.columns]});
      }
    }
  });
  drawGather(path, of.font, of.crowd, asker, search,
             adaptive ? "adaptive: rows and columns as far as the asker's own reach"
                      : "fixed N-radius 4: the 9 x 9 cells around the asker",
             [&](Canvas& canvas, const Look& look) {
               for (const auto& [from, to] : net) canvas.line(look(from), look(to), 5.0f, kLooked);
             });
}

// Near the middle, and typical: as many neighbours as usual, and both windows miss a neighbour.
Cell chooseAsker(const Picture& of, KeptGrid& kept) {
  Cell best{};
  float nearest = kInfinity;
  const float r = of.crowd.radius;
  launch(kept.queue, [&] {
    const NGridView<Cell> view = kept.grid.view(kept.cells.data());
    for (uint32_t i = 0; i < of.n(); ++i) {
      const Cell cell = of.crowd.byId[i];
      const float x = cell.x - 0.5f * of.crowd.world[0], y = cell.y - 0.5f * of.crowd.world[1];
      if (x * x + y * y >= nearest) continue;
      Search all{}, fixed{}, adaptive{};
      ask(BruteForce<Cell>{view.cells, kept.grid.dimensions().cells()}, 0, cell, r, all);
      ask(FixedGather<Cell>{view}, kept.cellOf.data()[i], cell, r, fixed);
      ask(AdaptiveGather<Cell>{view}, kept.cellOf.data()[i], cell, r, adaptive);
      const size_t missed = all.found.size() - adaptive.found.size();
      if (all.found.size() != 1 + size_t(kNeighbours) || all.found.size() == fixed.found.size() || missed < 2 ||
          missed > 4) {
        continue;
      }
      nearest = x * x + y * y;
      best = cell;
    }
  });
  if (nearest == kInfinity) throw std::runtime_error("No entity is typical; choose another crowd.");
  return best;
}

}  // namespace

void drawGathers(const std::string& folder, const TextFont& font) {
  const Crowd<Cell> crowd(8192, Distribution::uniform, 1);
  const Picture of{font, crowd};
  KeptGrid settled(crowd.byId, chooseWindowDimensions(of.n(), of.box()));
  settled.grid.sortUntilStable(settled.queue, settled.cells.data(), settled.cellOf.data());
  const Cell asker = chooseAsker(of, settled);
  drawRows(folder + "/ngrid_gather_exact.png", of, asker);
  drawWindow(folder + "/ngrid_gather_fixed.png", of, settled, asker, false);
  drawWindow(folder + "/ngrid_gather_adaptive.png", of, settled, asker, true);
  drawBins(folder + "/ngrid_gather_grid.png", of, asker);
}

}  // namespace gw::bench
