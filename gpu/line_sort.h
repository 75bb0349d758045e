// Sorting one line of cells, by a whole team, in shared memory. The order is total (ties go to the other
// axes, then to the id), so the result is unique and each device uses what suits it: bitonic merging
// (Batcher 1968) on cuda; on cpu insertion, which is linear when little has moved, and digits when much has.
#pragma once

#include <cstdint>

#include "gpu/bits.h"
#include "gpu/exec.h"
#include "gpu/neighbour.h"
#include "gpu/plain_types.h"

#if !GW_ON_CUDA
#include <algorithm>
#endif

namespace gw::GW_DEVICE {

// The orders of lines along each axis: x, y, z; y, x, z; z, y, x; then id.
struct ByX {
  template <class CellT>
  GW_MEMBER float along(const CellT& cell) const {
    return cell.x;
  }
  template <class CellT>
  GW_MEMBER bool operator()(const CellT& a, const CellT& b) const {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    const float aZ = heightOf(placeOf(a)), bZ = heightOf(placeOf(b));
    if (aZ != bZ) return aZ < bZ;
    return a.id < b.id;
  }
};

struct ByY {
  template <class CellT>
  GW_MEMBER float along(const CellT& cell) const {
    return cell.y;
  }
  template <class CellT>
  GW_MEMBER bool operator()(const CellT& a, const CellT& b) const {
    if (a.y != b.y) return a.y < b.y;
    if (a.x != b.x) return a.x < b.x;
    const float aZ = heightOf(placeOf(a)), bZ = heightOf(placeOf(b));
    if (aZ != bZ) return aZ < bZ;
    return a.id < b.id;
  }
};

struct ByZ {
  template <class CellT>
  GW_MEMBER float along(const CellT& cell) const {
    return heightOf(placeOf(cell));
  }
  template <class CellT>
  GW_MEMBER bool operator()(const CellT& a, const CellT& b) const {
    const float aZ = heightOf(placeOf(a)), bZ = heightOf(placeOf(b));
    if (aZ != bZ) return aZ < bZ;
    if (a.y != b.y) return a.y < b.y;
    if (a.x != b.x) return a.x < b.x;
    return a.id < b.id;
  }
};

#if GW_ON_CUDA

// line has room for the next power of two above length; its tail is filled with cells past every id.
template <uint32_t kLanes, class Team, class CellT, class Less>
GW_BODY void sortLine(const Team& team, CellT* line, uint32_t length, Less less) {
  uint32_t padded = 1;
  while (padded < length) padded *= 2;
  team.phase([&](uint32_t lane) {
    for (uint32_t i = length + lane; i < padded; i += kLanes) line[i] = deadCell(CellT{}, 0xFFFFFFFFu);
  });
  for (uint32_t run = 2; run <= padded; run *= 2) {
    for (uint32_t step = run / 2; step > 0; step /= 2) {
      team.phase([&](uint32_t lane) {
        for (uint32_t i = lane; i < padded; i += kLanes) {
          const uint32_t partner = i ^ step;
          if (partner <= i) continue;
          const bool ascending = (i & run) == 0;
          if (less(line[partner], line[i]) == ascending) {
            const CellT kept = line[i];
            line[i] = line[partner];
            line[partner] = kept;
          }
        }
      });
    }
  }
}

#else

// Insertion that gives up when more than `patience` moves show that the line was not nearly in order.
template <class CellT, class Less>
bool insertionSort(CellT* line, uint32_t length, uint64_t patience, Less less) {
  uint64_t moves = 0;
  for (uint32_t i = 1; i < length; ++i) {
    if (!less(line[i], line[i - 1])) continue;
    const CellT cell = line[i];
    uint32_t hole = i;
    do {
      line[hole] = line[hole - 1];
      --hole;
    } while (hole > 0 && less(cell, line[hole - 1]));
    line[hole] = cell;
    moves += i - hole;
    if (moves > patience) return false;
  }
  return true;
}

// By digits of the bits of the axis: all but ties, and the two zeros, are then in order. length up to kDigitsLine.
inline constexpr uint32_t kDigitsLine = 4096;
template <class CellT, class Less>
void digitSort(CellT* line, uint32_t length, Less less) {
  constexpr uint32_t kBits = 11, kPasses = 3, kValues = 1u << kBits;
  uint64_t keys[2][kDigitsLine];
  uint32_t counts[kPasses][kValues] = {};
  for (uint32_t i = 0; i < length; ++i) {
    const uint32_t bits = orderedBits(less.along(line[i]));
    keys[0][i] = uint64_t(bits) << 32 | i;
    for (uint32_t pass = 0; pass < kPasses; ++pass) ++counts[pass][bits >> (pass * kBits) & (kValues - 1)];
  }
  for (uint32_t pass = 0; pass < kPasses; ++pass) {
    uint32_t sum = 0;
    for (uint32_t& count : counts[pass]) {
      const uint32_t mine = count;
      count = sum;
      sum += mine;
    }
    const uint64_t* from = keys[pass % 2];
    for (uint32_t i = 0; i < length; ++i) {
      const uint32_t digit = uint32_t(from[i] >> (32 + pass * kBits)) & (kValues - 1);
      keys[1 - pass % 2][counts[pass][digit]++] = from[i];
    }
  }
  CellT sorted[kDigitsLine];
  for (uint32_t i = 0; i < length; ++i) sorted[i] = line[uint32_t(keys[kPasses % 2][i])];
  std::copy(sorted, sorted + length, line);
}

template <uint32_t kLanes, class Team, class CellT, class Less>
void sortLine(const Team&, CellT* line, uint32_t length, Less less) {
  if (insertionSort(line, length, 4ull * length, less)) return;
  if (length >= 64 && length <= kDigitsLine) {
    digitSort(line, length, less);
    if (insertionSort(line, length, 4ull * length, less)) return;
  }
  std::sort(line, line + length, less);
}

#endif

}  // namespace gw::GW_DEVICE
