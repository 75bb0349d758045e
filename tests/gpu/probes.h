// What the tests of gpu/ run on a device. Each probe makes a queue with the given options, uploads, launches,
// downloads; so a test is host code that knows no device, and the same case can be run on both.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/exec/exec_options.h"
#include "gpu/math/plain_types.h"

namespace gw::test {

using Words = std::vector<uint64_t>;

struct GridShape {
  uint32_t columns = 0, rows = 0, slabs = 1;
  uint32_t lines() const { return rows * slabs; }
  uint32_t cells() const { return columns * lines(); }
};

// packed: rebuilt, then packed. repacked: rebuilt, then all places multiplied by kStretch, then packed: by levels that
// all have outgrown.
enum class Upkeep : uint32_t { maintain, rebuild, refresh, transpose, sortUntilStable, pack, repack };
inline constexpr float kStretch = 1.25f;

// What binning leaves behind.
struct Binned {
  std::vector<Cell> cells;
  std::vector<uint32_t> cellOf, begin;
};

// Everything that NGrid upkeep leaves behind. A transposition leaves nothing about the rows.
template <class CellT>
struct GridStateOf {
  std::vector<CellT> cells;
  std::vector<uint32_t> cellOf;
  uint32_t moved = 0;
  // Per line (a row of any slab).
  std::vector<uint32_t> living;
  std::vector<float> low, high, reachHigh, reachLow;
  std::vector<float> near, far;                    // the interval of z; 3D only
  std::vector<float> slabReachHigh, slabReachLow;  // per slab; 3D only
  std::vector<uint32_t> starts;                    // [lines][parts + 1]
};
using GridState = GridStateOf<Cell>;
using GridState3 = GridStateOf<Cell3>;

// What an upkeep reports, and the mean steps of the arrangement that it left.
struct GridReport {
  uint32_t misaligned, moved, rounds;
  float steps[3];
};

struct Query {
  float x, y, radius;
};
struct Query3 {
  float x, y, z, radius;
};

// What the uniform grids of the probes cover, and the size of their bins, as different as the shapes are.
inline constexpr float kRegion = 100.0f;
inline float binSizeFor(uint32_t cells) {
  return 0.4f + 0.37f * float(cells % 29);
}

// Those after noMistake have one planted mistake each (broken_gather.h); noMistake is the same code without it.
enum class Method : uint32_t {
  rows,
  frozenRows,
  packedRows,
  builtRows,
  bruteForce,
  grid,
  hashedGrid,
  noMistake,
  prunesByEdge,
  forgetsLastRow,
  stopsBeforeBoundary,
  trustsRowOrder,
};

// How a cell of the grid asks for what is around it.
enum class Around : uint32_t { rows, packedRows, bruteForce, grid, hashedGrid, fixedWindow, adaptiveWindow };

struct Gathered {
  std::vector<uint32_t> found;   // [query][id / 32] a bit for each neighbour
  std::vector<uint32_t> visits;  // [query] neighbours, counted one by one
  std::vector<uint32_t> tested;  // [query] pair tests
};

// NeighbourLists.
struct Lists {
  std::vector<uint32_t> begin, neighbours;
};

struct Probes {
  // Visits per item, of capacity + 1024 items, when `live` (if any: used as the device-side count) are to run.
  std::vector<uint32_t> (*countVisits)(const ExecOptions&, uint32_t capacity, const uint32_t* live);
  // Teams of 128 lanes, several phases each: lines of 128 words, reversed and folded (see foldLineOnHost).
  Words (*foldLines)(const ExecOptions&, const Words& lines);
  // One team with 64 KiB of shared memory reverses 16,384 words.
  std::vector<uint32_t> (*reverseBigLine)(const ExecOptions&, const std::vector<uint32_t>&);
  // {sum of the low halves mod 2^32, largest word, sum mod 2^64}, all by atomics.
  Words (*atomics)(const ExecOptions&, const Words&);
  // Three launches captured once and replayed `ticks` times: the words after that.
  Words (*replayGraph)(const ExecOptions&, const Words&, uint32_t ticks);

  // Bits of sine, cosine, arcTangent2(y, x), exponential, length, normalised; NaN as one pattern.
  std::vector<uint32_t> (*exactMath)(const ExecOptions&, const std::vector<Float2>&);
  std::vector<Uint4> (*philox)(const ExecOptions&, uint64_t key, const std::vector<Uint4>& counters);
  std::vector<uint32_t> (*unitFloats)(const ExecOptions&, const std::vector<uint32_t>& bits);
  std::vector<int32_t> (*fixedTerms)(const ExecOptions&, const std::vector<float>&, float scale);
  Words (*hashWords)(const ExecOptions&, const Words&);

  Words (*scan)(const ExecOptions&, const Words&);  // what stands before each item, then the total
  uint64_t (*reduce)(const ExecOptions&, const Words&);
  Words (*sortKeys)(const ExecOptions&, const Words&);

  std::vector<Cell> (*sortLineByX)(const ExecOptions&, const std::vector<Cell>&);
  std::vector<Cell> (*sortLineByY)(const ExecOptions&, const std::vector<Cell>&);
  std::vector<Cell3> (*sortLineByZ)(const ExecOptions&, const std::vector<Cell3>&);
  GridState (*upkeep)(const ExecOptions&, GridShape, const std::vector<Cell>&, Upkeep);
  GridState3 (*upkeep3)(const ExecOptions&, GridShape, const std::vector<Cell3>&, Upkeep);
  // After one upkeep, of an arrangement whose cellOf was right.
  GridReport (*report)(const ExecOptions&, GridShape, const std::vector<Cell>&, Upkeep);
  GridReport (*report3)(const ExecOptions&, GridShape, const std::vector<Cell3>&, Upkeep);
  // The cells in the order of their bins, and the indexes in that of their buckets (as cellOf; the cells stay).
  Binned (*binCells)(const ExecOptions&, const std::vector<Cell>&);
  Binned (*hashCells)(const ExecOptions&, const std::vector<Cell>&);
  // Maintains what the method needs, then searches.
  Gathered (*gather)(const ExecOptions&, GridShape, const std::vector<Cell>&, const std::vector<Query>&, Method);
  // Maintains, then lets every living cell look around itself, and at what comes after it: found and visits are
  // [cell] of the first, tested of both.
  Gathered (*gatherAround)(const ExecOptions&, GridShape, const std::vector<Cell>&, float radius, Around);
  // The same in three dimensions. No methods with a mistake.
  Gathered (*gather3)(const ExecOptions&, GridShape, const std::vector<Cell3>&, const std::vector<Query3>&, Method);
  // Methods: rows, packedRows, bruteForce, grid, hashedGrid.
  Lists (*lists)(const ExecOptions&, GridShape, const std::vector<Cell>&, float radius, Method);
  Lists (*lists3)(const ExecOptions&, GridShape, const std::vector<Cell3>&, float radius, Method);
  Gathered (*gatherAround3)(const ExecOptions&, GridShape, const std::vector<Cell3>&, float radius, Around);
};

}  // namespace gw::test

namespace gw::cpu {
test::Probes probes();
}
#ifdef GW_HAVE_CUDA
namespace gw::cuda {
test::Probes probes();
}
#endif
