// Sorting one line of cells where it stands, by one lane. For the cpu device only; block_lines.h is its counterpart.
// The orders of line_order.h are total, so the result is unique and each device does what suits it: here insertion,
// which is linear when little has moved, and digits when much has. Not for users of the NGrid.
#pragma once

#include <gpuwars/bits.h>
#include <gpuwars/ngrid_dimensions.h>

#include <algorithm>
#include <cstdint>

namespace gw::GW_DEVICE {

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

// By digits of the bits of the axis: all but ties, and the two zeros, are then in order. length up to kLongestLine.
template <class CellT, class Less>
void digitSort(CellT* line, uint32_t length, Less less) {
  constexpr uint32_t kBits = 11, kPasses = 3, kValues = 1u << kBits;
  uint64_t keys[2][kLongestLine];
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
  CellT sorted[kLongestLine];
  for (uint32_t i = 0; i < length; ++i) sorted[i] = line[uint32_t(keys[kPasses % 2][i])];
  std::copy(sorted, sorted + length, line);
}

// length up to kLongestLine.
template <class CellT, class Less>
void sortLine(CellT* line, uint32_t length, Less less) {
  if (insertionSort(line, length, 4ull * length, less)) return;
  if (length >= 64) {
    digitSort(line, length, less);
    if (insertionSort(line, length, 4ull * length, less)) return;
  }
  std::sort(line, line + length, less);
}

}  // namespace gw::GW_DEVICE
