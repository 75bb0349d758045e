#include <gpuwars/bin_sort.h>
#include <gpuwars/bits.h>

namespace gw::GW_DEVICE {

#if GW_ON_CUDA

namespace {

// One item: one key of the sorted ones, which marks the beginnings of its bin and of the empty ones before it; one
// more item than keys marks those after the last.
struct MarkBegins {
  uint32_t* begin;
  const uint64_t* keys;
  uint32_t count, bins;

  GW_BODY void operator()(uint32_t i) const {
    const uint32_t first = i == 0 ? 0 : uint32_t(keys[i - 1] >> 32) + 1;
    const uint32_t last = i == count ? bins : uint32_t(keys[i] >> 32);
    for (uint32_t b = first; b <= last; ++b) begin[b] = i;
  }
};

}  // namespace

BinSort::BinSort(Queue& queue, uint32_t count, uint32_t bins, bool wantsBegin)
    : count_(count), bins_(bins), keys_(queue, count) {
  if (wantsBegin) begin_ = Buffer<uint32_t>(queue, size_t(bins) + 1);
}

void BinSort::sort(Queue& queue) {
  keys_.run(queue, 32, 32 + bitsBelow(bins_));
  if (begin_.size() > 0) forEach(queue, Count{count_ + 1}, MarkBegins{begin_.data(), keys_.keys(), count_, bins_});
}

size_t BinSort::bytes() const {
  return begin_.size() * sizeof(uint32_t) + keys_.bytes();
}

#else

namespace {

constexpr uint32_t kRange = 1024;

// One team: the sum of one range of bins over all slices.
struct SumRange {
  static constexpr uint32_t kLanes = 1;
  struct Shared {};
  uint32_t* sums;
  const uint32_t* counts;
  uint32_t bins, slices;

  template <class Team>
  void operator()(const Team& team, Shared&) const {
    const uint32_t first = team.index * kRange, last = smaller(first + kRange, bins);
    uint32_t sum = 0;
    for (uint32_t s = 0; s < slices; ++s) {
      for (uint32_t b = first; b < last; ++b) sum += counts[size_t(s) * bins + b];
    }
    sums[team.index] = sum;
  }
};

// One team: turns the counts of one range of bins into where each slice's items of each bin go.
struct PlaceRange {
  static constexpr uint32_t kLanes = 1;
  struct Shared {};
  uint32_t *begin, *counts;
  const uint32_t* sums;
  uint32_t bins, slices, items;

  template <class Team>
  void operator()(const Team& team, Shared&) const {
    uint32_t at = 0;
    for (uint32_t range = 0; range < team.index; ++range) at += sums[range];
    const uint32_t first = team.index * kRange, last = smaller(first + kRange, bins);
    for (uint32_t b = first; b < last; ++b) {
      begin[b] = at;
      for (uint32_t s = 0; s < slices; ++s) {
        uint32_t& count = counts[size_t(s) * bins + b];
        const uint32_t mine = count;
        count = at;
        at += mine;
      }
    }
    if (last == bins) begin[bins] = items;
  }
};

// Enough slices for a few workers, few enough that their tables stay small beside the items.
uint32_t slicesFor(uint32_t count) {
  const uint32_t wanted = count / 4096;
  return wanted < 1 ? 1 : wanted > 8 ? 8 : wanted;
}

}  // namespace

BinSort::BinSort(Queue& queue, uint32_t count, uint32_t bins, bool)
    : count_(count),
      bins_(bins),
      begin_(queue, size_t(bins) + 1),
      slices_(slicesFor(count)),
      perSlice_((count + slices_ - 1) / slices_),
      counts_(queue, size_t(slices_) * bins),
      binOfItem_(queue, count),
      ranges_(queue, (bins + kRange - 1) / kRange) {}

void BinSort::scan(Queue& queue) {
  const uint32_t ranges = (bins_ + kRange - 1) / kRange;
  forEachTeam(queue, ranges, SumRange{ranges_.data(), counts_.data(), bins_, slices_});
  forEachTeam(queue, ranges, PlaceRange{begin_.data(), counts_.data(), ranges_.data(), bins_, slices_, count_});
}

size_t BinSort::bytes() const {
  return (begin_.size() + counts_.size() + binOfItem_.size() + ranges_.size()) * sizeof(uint32_t);
}

#endif

}  // namespace gw::GW_DEVICE
