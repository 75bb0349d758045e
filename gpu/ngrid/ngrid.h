// NGrid: the neighbourhood structure of Joselli's thesis (2013), in two dimensions (CellT is Cell) and three (Cell3).
// n entities stand in n cells, and the array of their positions *is* the grid.
//
//      column 0   1   2   3          Every row is in ascending x, and every column nearly in ascending y:
//   row 2   [.4] [.5] [.6] [.7]      an entity's neighbours in the world stand near it in the grid. In 3D such
//   row 1   [.2] [.1] [.3] [.9]      slabs of rows follow each other, each pole through them nearly in ascending z.
//   row 0   [.0] [.8] [.a] [.b]      Dead cells sit at +infinity, so sorting groups them at the end.
//
// Properties (thesis, chapter 4):
//   1 as many cells as entities               2 one entity per cell
//   3 a cell takes its entity's size          4 and its place
//   5 the N-dimensions multiply to n          6 each line is ordered along its axis
//   7 one N-radius per axis                   8 the N-radius is fixed or adaptive
// 6 holds for rows after every maintain(); other lines are misaligned by what later passes moved. 7 and 8 speak of
// windowed gathering (window_gather.h); the exact gather of row_gather.h needs no N-radius.
//
// Upkeep after motion, from the thesis: maintain() sorts every line of each axis, transpose() only compares neighbours.
// Our own, for exact gathers: pack() redistributes the entities into rows by counting, refresh() leaves them in
// their rows. Two orders to start from: rebuild() and sortUntilStable(). Ties are broken by the other axes, then by id,
// so the order of a line is unique on every device.
//
// An entity at x = +infinity is dead, whatever its other coordinates. Places are not NaN: quarantine() turns those
// that are into dead cells and counts them.
#pragma once

#include <gpuwars/bin_sort.h>
#include <gpuwars/bits.h>
#include <gpuwars/buffer.h>
#include <gpuwars/ngrid_dimensions.h>
#include <gpuwars/plain_types.h>

#include <vector>

namespace gw::GW_DEVICE {

// See NGrid::rowsWidened().
inline constexpr float kWorthRebuilding = 1.05f;

// Of places along an axis.
struct Interval {
  float low, high;  // m; +infinity and -infinity when nothing is in it
};

// Equal parts that an interval is cut into: place `low` begins the first.
struct Scale {
  float low, perMetre;  // m; parts per metre, 0 when all is in the first
};

// Of the whole grid.
struct GridTotals {
  float height, heightBuilt;  // m, of all rows together: now, after the last rebuild() or pack()
  Interval x, y, z;           // of all the living
  Scale parts, slabs;         // of x and of z, of the indexes below
  uint32_t moved;             // entities that the last pass has put into another cell
};

// Of one slab.
struct GridSlab {
  Scale rows;      // parts of y of the index below
  Interval reach;  // z, 3D only: the lowest of this and later slabs, the highest of this and earlier ones
};

// The part, of so many, that a place falls into: monotonic in it, and 0 for NaN.
GW_FN uint32_t partOf(Scale scale, uint32_t parts, float place) {
  const float part = (place - scale.low) * scale.perMetre, last = float(int32_t(parts - 1));
  return uint32_t(int32_t(part > 0.0f ? (part < last ? part : last) : 0.0f));
}

// Parts of the indexes of rows, for each row, and of slabs, for each slab.
inline constexpr uint32_t kPartsPerRow = 8;

// What kernels see. Copy it into a kernel by value. A "line" here is a row of any slab: slab * rows + row.
template <class CellT>
struct NGridView {
  const CellT* cells;             // [lines][columns]
  uint32_t columns, rows, slabs;  // NGrid::dimensions()
  // Per line, of its living: y; z, in 3D only; how many.
  const Interval *height, *depth;  // [lines]
  const uint32_t* living;          // not used by searches; for reports
  // Per line, of its slab: the lowest y of this and later rows, the highest of this and earlier ones. Both ascend, so
  // the rows that can meet an interval follow each other.
  const Interval* reach;
  const GridSlab* slab;      // [slabs]
  const GridTotals* totals;  // [1]
  // Where to begin, for each part of a line's x (the first column in it or a later one; at last the number of the
  // living), of a slab's y (the first row that reaches into it or beyond) and, in 3D only, of z (the same of slabs).
  const uint16_t* firstColumn;  // [lines][parts + 1]
  const uint16_t* firstRow;     // [slabs][rows * kPartsPerRow]
  const uint16_t* firstSlab;    // [slabs * kPartsPerRow]
  uint32_t parts;               // of x, of every line
  // Rows are in ascending x throughout, not only by parts.
  bool sorted;

  // See NGrid::rowsWidened().
  GW_MEMBER float widened() const {
    const float now = totals->height, built = totals->heightBuilt;
    if (!(now < kInfinity)) return kInfinity;
    return built > 0.0f ? now / built : now > 0.0f ? kInfinity : 0.0f;
  }
};

// How a grid is going to be kept. inPlace: by maintain() or transpose(), with little memory beyond the cells: 50 bytes
// a row and at most 24 KB, so under 64 KB for a million in 2D by chooseDimensions(). packed: by pack() and refresh()
// too, which need about 24 bytes for each cell on cpu, 30 in 3D; on cuda about 35 and 51.
enum class Kept { inPlace, packed };

// What NGrid::report() counts.
struct UpkeepReport {
  uint32_t misaligned;  // the living that stand before their predecessor on a line of any axis
  // Entities that the last pass has put into another cell; a swap moves two. None after sortUntilStable(), nor after
  // rebuild() in place, which ends by a pass that finds all in order.
  uint32_t moved;
  uint32_t rounds;  // of passes along all axes that it took
  float widened;    // NGrid::rowsWidened()
};

struct FindReach;  // ngrid_reach.h
struct RowsFound;  // ngrid_rows.h

// Keeps the caller's cells in order, and owns what searches need to know of the rows. d_cells and d_cellOf are device
// addresses of the caller: they outlive every view and every launch that uses one. The queue outlives the grid.
// Move-only.
//
// Errors: bad arguments are std::invalid_argument, a call out of order (pack() before rebuild()) std::logic_error, both
// before anything is launched; no room is DeviceOutOfMemory on cuda, std::runtime_error on cpu; only the constructor,
// rebuild(), steps() and quarantine() allocate. What fails on the device shows at the next call that waits (exec.h).
template <class CellT>
class NGrid {
 public:
  NGrid() = default;
  // Throws std::invalid_argument when a dimension is 0 or above kLongestLine, or their product 2^31 or more.
  NGrid(Queue& queue, NDimensions dimensions, Kept kept = Kept::inPlace);

  // As it was made with.
  NDimensions dimensions() const { return dimensions_; }
  // What kernels see of the grid after the last upkeep; valid until the next, and while this lives.
  NGridView<CellT> view(const CellT* d_cells) const;
  size_t bytes() const;  // of device memory beyond the cells, held between calls

  // In all that follows d_cells is [cells] and d_cellOf [cells]: upkeep leaves in d_cellOf[id] the cell of that id (ids
  // are 0 .. cells - 1, each in exactly one cell). Null pointers throw std::invalid_argument. n is the number of cells,
  // m that of the longest line.

  // Upkeep after motion: sorts each pole by z, each column by y, then each row by x, and refreshes what is known of the
  // rows. One pass per axis: O(n log^2 m) bitonic on cuda; on cpu insertion, O(n) for the small motion of one
  // tick. One launch per axis. Nothing is done while the word at d_hold (if any) is not 0: a captured tick cannot leave
  // a launch out.
  void maintain(Queue& queue, CellT* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold = nullptr);

  // Upkeep by partial odd-even transposition: one odd and one even pass along each axis (four steps in 2D, six in 3D),
  // O(n), one launch per axis. An entity moves by at most two cells per axis, so one that is far from its place takes
  // many calls to reach it; a single line of m cells is in order after at most m / 2 calls (rounded up), and repeated
  // calls without motion end with every line in order. Rows are not in order after one call and nothing is known of
  // them: for windowed gathers only.
  void transpose(Queue& queue, CellT* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold = nullptr);

  // Upkeep for exact gathers, of a packed grid: redistributes all entities into rows, by counting levels of y (in 3D
  // first slabs by levels of z), each row put into parts of x. Nearly as good as rebuild(), for a fraction of its
  // cost whatever has moved: O(n). Levels span what the living spanned after the upkeep before. Rows are in ascending
  // x by parts only. Follows a rebuild(), else throws std::logic_error. One launch and those of BinSort, in 3D of two.
  void pack(Queue& queue, CellT* d_cells, uint32_t* d_cellOf);

  // Upkeep with frozen rows, of a packed grid: who stands in which row stays as it is, each row is put into parts of x,
  // and what is known of rows is refreshed. Exact gathers stay exact and slow down while the rows widen: pack() when
  // rowsWidened() says so. O(n), one launch.
  void refresh(Queue& queue, CellT* d_cells, uint32_t* d_cellOf);

  // The summed heights of the rows by what they were after the last rebuild() or pack(); infinite when they had none
  // then, 0 when they have none now. pack() pays above about kWorthRebuilding. Waits for the queue.
  float rowsWidened() const;

  // The full sort: all cells by y, cut into rows, each row by x (in 3D by z, cut into slabs, and those by y; the
  // packing of sort-tile-recursive R-trees, Leutenegger et al. 1997). What exact gathers start from; it depends
  // on the entities only, not on where they stood. O(n); allocates 36 bytes for each cell while it runs (on cuda
  // some more) and waits, so it is for starts, not for frames.
  void rebuild(Queue& queue, CellT* d_cells, uint32_t* d_cellOf);

  // The other full sort: maintain() until nothing moves. What windowed gathers start from: in the order of rebuild() a
  // window misses half of the neighbours. It ends, because each sort of a line raises the sum of place times
  // coordinate. Uniform places take 8 to 13 rounds. Waits for the queue after each.
  void sortUntilStable(Queue& queue, CellT* d_cells, uint32_t* d_cellOf);

  // How well the lines are in order and what the last upkeep did. O(n); waits for the queue.
  UpkeepReport upkeepReport(Queue& queue, const CellT* d_cells);

  // See Steps. O(n); waits for the queue.
  Steps steps(Queue& queue, const CellT* d_cells);

  // Turns cells with a coordinate that is not a number into dead ones; how many. Sorting and searching know no NaN.
  // O(n); waits for the queue.
  uint32_t quarantine(Queue& queue, CellT* d_cells);

 private:
  void sortRows(Queue& queue, CellT* d_cells, uint32_t* d_cellOf, const uint32_t* d_hold, bool built);
  void splitRows(Queue& queue, CellT* d_cells, const CellT* d_from, uint32_t* d_cellOf, bool built);
  FindReach findReach(bool built) const;
  void requirePacked() const;
  RowsFound found() const;
  GridTotals totals() const;

  NDimensions dimensions_;
  Kept kept_ = Kept::inPlace;
  bool known_ = false;  // something of the rows
  uint32_t parts_ = 0, rounds_ = 0;
  Buffer<Interval> width_, height_, depth_, reach_;
  Buffer<uint32_t> living_, moved_;
  Buffer<uint32_t> arrived_;  // KeepRows
  Buffer<GridSlab> slab_;
  Buffer<GridTotals> totals_, slabTotals_;  // the latter in 3D only
  Buffer<uint16_t> firstColumn_, firstRow_, firstSlab_;
  // Of a packed grid only.
  BinSort byZ_, byY_;
  Buffer<CellT> aside_;
};

// The n entities given, and as many dead cells behind them as `dimensions` have room for: what a grid is filled with.
// Ids become 0 .. cells - 1 in order. Throws std::invalid_argument when n is 0 or more than there are cells, and when a
// coordinate is NaN (it names the entity).
template <class CellT>
std::vector<CellT> padded(const std::vector<CellT>& entities, NDimensions dimensions);

}  // namespace gw::GW_DEVICE
