// Sorting one line of cells, by a whole team, in shared memory. The order is total (ties go to the other
// axis, then to the id), so the result is unique and each device uses what suits it: bitonic merging
// (Batcher 1968) on cuda, insertion on cpu, which is linear when little has moved.
#pragma once

#include <cstdint>

#include "gpu/bits.h"
#include "gpu/exec.h"
#include "gpu/plain_types.h"

#if !GW_ON_CUDA
#include <algorithm>
#endif

namespace gw::GW_DEVICE {

struct ByX {
  GW_MEMBER bool operator()(const Cell& a, const Cell& b) const {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.id < b.id;
  }
};

struct ByY {
  GW_MEMBER bool operator()(const Cell& a, const Cell& b) const {
    if (a.y != b.y) return a.y < b.y;
    if (a.x != b.x) return a.x < b.x;
    return a.id < b.id;
  }
};

#if GW_ON_CUDA

// line has room for the next power of two above length; its tail is filled with cells past every id.
template <uint32_t kLanes, class Team, class Less>
GW_BODY void sortLine(const Team& team, Cell* line, uint32_t length, Less less) {
  uint32_t padded = 1;
  while (padded < length) padded *= 2;
  team.phase([&](uint32_t lane) {
    for (uint32_t i = length + lane; i < padded; i += kLanes) line[i] = {kInfinity, kInfinity, 0xFFFFFFFFu, 0u};
  });
  for (uint32_t run = 2; run <= padded; run *= 2) {
    for (uint32_t step = run / 2; step > 0; step /= 2) {
      team.phase([&](uint32_t lane) {
        for (uint32_t i = lane; i < padded; i += kLanes) {
          const uint32_t partner = i ^ step;
          if (partner <= i) continue;
          const bool ascending = (i & run) == 0;
          if (less(line[partner], line[i]) == ascending) {
            const Cell kept = line[i];
            line[i] = line[partner];
            line[partner] = kept;
          }
        }
      });
    }
  }
}

#else

template <uint32_t kLanes, class Team, class Less>
void sortLine(const Team&, Cell* line, uint32_t length, Less less) {
  uint64_t moves = 0;
  const uint64_t patience = 12ull * length;  // beyond it the line was not nearly sorted
  for (uint32_t i = 1; i < length; ++i) {
    if (!less(line[i], line[i - 1])) continue;
    const Cell cell = line[i];
    uint32_t hole = i;
    do {
      line[hole] = line[hole - 1];
      --hole;
    } while (hole > 0 && less(cell, line[hole - 1]));
    line[hole] = cell;
    moves += i - hole;
    if (moves > patience) {
      std::sort(line, line + length, less);
      return;
    }
  }
}

#endif

}  // namespace gw::GW_DEVICE
