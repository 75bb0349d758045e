#include <cmath>
#include <stdexcept>
#include <string>

#include "gpu/line_sort.h"
#include "gpu/neighbour.h"
#include "gpu/ngrid.h"

namespace gw::GW_DEVICE {
namespace {

constexpr uint32_t kLineLanes = GW_ON_CUDA ? 256 : 1;  // on cpu one lane walks along its line

// One team: a tile of neighbouring columns, each sorted by y. On cpu a tile is one cache line wide.
struct SortColumns {
  static constexpr uint32_t kLanes = kLineLanes;
  static constexpr uint32_t kTile = GW_ON_CUDA ? 1 : 4;
  struct Shared {
    Cell line[kTile][kLongestLine];
  };
  Cell* cells;
  const uint32_t* hold;
  NDimensions dimensions;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    if (hold && *hold) return;  // all teams alike
    const uint32_t first = team.index * kTile, columns = dimensions.columns, rows = dimensions.rows;
    const uint32_t tile = columns - first < kTile ? columns - first : kTile;
    team.phase([&](uint32_t lane) {
      for (uint32_t row = lane; row < rows; row += kLanes) {
        for (uint32_t t = 0; t < tile; ++t) s.line[t][row] = cells[row * columns + first + t];
      }
    });
    for (uint32_t t = 0; t < tile; ++t) sortLine<kLanes>(team, s.line[t], rows, ByY{});
    team.phase([&](uint32_t lane) {
      for (uint32_t row = lane; row < rows; row += kLanes) {
        for (uint32_t t = 0; t < tile; ++t) cells[row * columns + first + t] = s.line[t][row];
      }
    });
  }
};

// One team: one row, sorted by x; then its interval of y, its living, and where each id now stands.
struct SortRows {
  static constexpr uint32_t kLanes = kLineLanes;
  struct Shared {
#if GW_ON_CUDA
    Cell line[kLongestLine];
#endif
    float low[kLanes], high[kLanes];
    uint32_t living[kLanes];
  };
  Cell* cells;
  uint32_t* cellOf;
  float *low, *high, *left, *perMetre;
  uint32_t* living;
  uint16_t* starts;
  const uint32_t* hold;
  uint32_t columns, buckets;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    if (hold && *hold) return;
    const uint32_t begin = team.index * columns;
#if GW_ON_CUDA
    Cell* const line = s.line;
    team.phase([&](uint32_t lane) {
      for (uint32_t c = lane; c < columns; c += kLanes) line[c] = cells[begin + c];
    });
#else
    Cell* const line = cells + begin;  // where it is
#endif
    sortLine<kLanes>(team, line, columns, ByX{});
    team.phase([&](uint32_t lane) {
      float least = kInfinity, most = -kInfinity;
      uint32_t count = 0;
      for (uint32_t c = lane; c < columns; c += kLanes) {
        const Cell cell = line[c];
#if GW_ON_CUDA
        cells[begin + c] = cell;
#endif
        cellOf[cell.id] = begin + c;
        if (isLiving(cell.x)) {
          least = smaller(least, cell.y);
          most = larger(most, cell.y);
          ++count;
        }
      }
      s.low[lane] = least;
      s.high[lane] = most;
      s.living[lane] = count;
    });
    for (uint32_t half = kLanes / 2; half > 0; half /= 2) {
      team.phase([&](uint32_t lane) {
        if (lane >= half) return;
        s.low[lane] = smaller(s.low[lane], s.low[lane + half]);
        s.high[lane] = larger(s.high[lane], s.high[lane + half]);
        s.living[lane] += s.living[lane + half];
      });
    }
    team.phase([&](uint32_t lane) {
      if (lane != 0) return;
      low[team.index] = s.low[0];
      high[team.index] = s.high[0];
      living[team.index] = s.living[0];
    });
    team.phase([&](uint32_t lane) { indexRow(team.index, line, lane, s.living[0]); });
  }

  // Lane by lane: the parts of x that begin at each living cell, then those after the last.
  GW_BODY void indexRow(uint32_t row, const Cell* line, uint32_t lane, uint32_t count) const {
    const float from = count ? line[0].x : 0.0f, width = count ? line[count - 1].x - from : 0.0f;
    const float scale = width > 0.0f ? float(buckets) / width : 0.0f;
    if (lane == 0) {
      left[row] = from;
      perMetre[row] = scale;
    }
    NGridView view{};
    view.left = &from;
    view.perMetre = &scale;
    view.buckets = buckets;
    uint16_t* mine = starts + row * (buckets + 1);
    for (uint32_t c = lane; c <= count; c += kLanes) {
      const uint32_t first = c == 0 ? 0 : view.bucketOf(0, line[c - 1].x) + 1;
      const uint32_t last = c == count ? buckets : view.bucketOf(0, line[c].x);
      for (uint32_t b = first; b <= last; ++b) mine[b] = uint16_t(c);
    }
  }
};

// As many parts as keep the whole index small; two for a cell are plenty.
uint32_t bucketsFor(NDimensions dimensions) {
  constexpr uint32_t kIndexBytes = 40 * 1024;
  const uint32_t fit = kIndexBytes / 2 / dimensions.rows, wanted = 2 * dimensions.columns;
  return larger(smaller(fit, wanted), 1u);
}

// One team in all: the running maximum of `high` and the running minimum, from behind, of `low`.
struct FindReach {
  static constexpr uint32_t kLanes = 64;
  struct Shared {
    float high[kLanes], low[kLanes], height[kLanes];
  };
  float *reachHigh, *reachLow, *heights;
  const float *high, *low;
  uint32_t rows, rebuilt;

  template <class Team>
  GW_BODY void operator()(const Team& team, Shared& s) const {
    const uint32_t each = (rows + kLanes - 1) / kLanes;
    team.phase([&](uint32_t lane) {
      float most = -kInfinity, least = kInfinity, height = 0.0f;
      for (uint32_t row = lane * each; row < (lane + 1) * each && row < rows; ++row) {
        most = larger(most, high[row]);
        least = smaller(least, low[row]);
        if (high[row] > low[row]) height += high[row] - low[row];
      }
      s.high[lane] = most;
      s.low[lane] = least;
      s.height[lane] = height;
    });
    team.phase([&](uint32_t lane) {
      float most = -kInfinity, least = kInfinity;
      for (uint32_t l = 0; l < lane; ++l) most = larger(most, s.high[l]);
      for (uint32_t l = lane + 1; l < kLanes; ++l) least = smaller(least, s.low[l]);
      if (lane == 0) {
        float height = 0.0f;
        for (uint32_t l = 0; l < kLanes; ++l) height += s.height[l];
        heights[0] = height;
        if (rebuilt) heights[1] = height;
      }
      const uint32_t begin = lane * each, end = smaller((lane + 1) * each, rows);
      for (uint32_t row = begin; row < end; ++row) reachHigh[row] = most = larger(most, high[row]);
      for (uint32_t row = end; row > begin; --row) reachLow[row - 1] = least = smaller(least, low[row - 1]);
    });
  }
};

// One item: one cell's key for the full sort. Equal y are told apart by the place the cell has now, which
// is by id only if the arrangement is: rebuild() callers hand in cells in the order of their ids.
struct MakeKeys {
  uint64_t* keys;
  const Cell* cells;
  GW_BODY void operator()(uint32_t i) const { keys[i] = uint64_t(orderedBits(cells[i].y)) << 32 | i; }
};

struct CopyCells {
  Cell* out;
  const Cell* in;
  GW_BODY void operator()(uint32_t i) const { out[i] = in[i]; }
};

struct TakeByKeys {
  Cell* out;
  const Cell* in;
  const uint64_t* keys;
  GW_BODY void operator()(uint32_t i) const { out[i] = in[uint32_t(keys[i])]; }
};

}  // namespace

NDimensions chooseDimensions(uint32_t n) {
  // Odd multiples of 16 cells: a stride that is a power of two would put a whole column into one cache set.
  uint32_t columns = 16;
  while (uint64_t(columns) * columns < 24ull * n && columns + 32 <= kLongestLine) columns += 32;
  NDimensions found{columns, n / columns + (n % columns ? 1 : 0)};
  if (found.rows == 0) found.rows = 1;
  if (found.rows > kLongestLine) {
    throw std::invalid_argument("An NGrid of " + std::to_string(n) + " cells is too large: at most " +
                                std::to_string(columns * kLongestLine) + " fit; use fewer entities.");
  }
  return found;
}

NDimensions chooseWindowDimensions(uint32_t n, float aspect) {
  if (!(aspect > 0.0f && aspect < kInfinity)) throw std::invalid_argument("A world has a width and a height.");
  const double wanted = std::sqrt(double(n) * double(aspect)) + 0.5;
  uint32_t columns = wanted < 1.0 ? 1 : wanted > kLongestLine ? kLongestLine : uint32_t(wanted);
  columns = larger(columns, n / kLongestLine + (n % kLongestLine ? 1 : 0));  // a world too tall for its rows
  if (columns > kLongestLine) {
    throw std::invalid_argument("An NGrid of " + std::to_string(n) + " cells is too large: at most " +
                                std::to_string(kLongestLine * kLongestLine) + " fit; use fewer entities.");
  }
  return {columns, larger(n / columns + (n % columns ? 1 : 0), 1u)};
}

// Before anything is allocated for them, and while their product may not fit 32 bits.
static NDimensions checked(NDimensions dimensions) {
  if (dimensions.columns == 0 || dimensions.columns > kLongestLine || dimensions.rows == 0 ||
      dimensions.rows > kLongestLine) {
    throw std::invalid_argument("An NGrid has 1 to " + std::to_string(kLongestLine) + " rows and columns.");
  }
  return dimensions;
}

NGrid::NGrid(Queue& queue, NDimensions dimensions)
    : dimensions_(checked(dimensions)),
      low_(queue, dimensions.rows),
      high_(queue, dimensions.rows),
      reachHigh_(queue, dimensions.rows),
      reachLow_(queue, dimensions.rows),
      left_(queue, dimensions.rows),
      perMetre_(queue, dimensions.rows),
      living_(queue, dimensions.rows),
      starts_(queue, dimensions.rows * (bucketsFor(dimensions) + 1)),
      buckets_(bucketsFor(dimensions)),
      byY_(queue, dimensions.cells()),
      scratch_(queue, dimensions.cells()),
      heights_(queue, 2) {}

NGridView NGrid::view(const Cell* d_cells) const {
  return {d_cells,           dimensions_.columns, dimensions_.rows, low_.data(),  high_.data(),     living_.data(),
          reachHigh_.data(), reachLow_.data(),    starts_.data(),   left_.data(), perMetre_.data(), buckets_,
          heights_.data()};
}

size_t NGrid::bytes() const {
  return size_t(dimensions_.rows) * (6 * sizeof(float) + sizeof(uint32_t)) + starts_.size() * sizeof(uint16_t) +
         byY_.bytes() + scratch_.size() * sizeof(Cell);
}

void NGrid::maintain(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold) {
  constexpr uint32_t kTile = SortColumns::kTile;
  forEachTeam(queue, (dimensions_.columns + kTile - 1) / kTile, SortColumns{d_cells, d_hold, dimensions_});
  sortRows(queue, d_cells, d_cellOf, d_hold, false);
}

void NGrid::refresh(Queue& queue, Cell* d_cells, uint32_t* d_cellOf) {
  sortRows(queue, d_cells, d_cellOf, nullptr, false);
}

float NGrid::rowsWidened() const {
  float heights[2];
  heights_.download(heights, 2);
  NGridView view{};
  view.heights = heights;
  return view.widened();
}

void NGrid::settle(Queue& queue, Cell* d_cells, uint32_t* d_cellOf) {
  constexpr uint32_t kRounds = 16;  // uniform data come to rest in 8 to 13
  for (uint32_t round = 0; round < kRounds; ++round) maintain(queue, d_cells, d_cellOf);
}

void NGrid::rebuild(Queue& queue, Cell* d_cells, uint32_t* d_cellOf) {
  const Count all{dimensions_.cells()};
  forEach(queue, all, MakeKeys{byY_.keys(), d_cells});
  byY_.run(queue, 32);
  forEach(queue, all, CopyCells{scratch_.data(), d_cells});
  forEach(queue, all, TakeByKeys{d_cells, scratch_.data(), byY_.keys()});
  sortRows(queue, d_cells, d_cellOf, nullptr, true);
}

void NGrid::sortRows(Queue& queue, Cell* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold, bool rebuilt) {
  forEachTeam(queue, dimensions_.rows,
              SortRows{d_cells, d_cellOf, low_.data(), high_.data(), left_.data(), perMetre_.data(), living_.data(),
                       starts_.data(), d_hold, dimensions_.columns, buckets_});
  forEachTeam(queue, 1,
              FindReach{reachHigh_.data(), reachLow_.data(), heights_.data(), high_.data(), low_.data(),
                        dimensions_.rows, rebuilt});
}

}  // namespace gw::GW_DEVICE
