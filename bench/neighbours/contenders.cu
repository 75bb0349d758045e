// Every way of gpu/ to find neighbours, behind one face.
#include <utility>

#include "bench/neighbours/contender.h"
#include "gpu/brute_force.h"
#include "gpu/hashed_grid.h"
#include "gpu/ngrid.h"
#include "gpu/row_gather.h"
#include "gpu/scan_reduce.h"
#include "gpu/uniform_grid.h"
#include "gpu/window_gather.h"

namespace gw::GW_DEVICE {
namespace {

using bench::Place;
using bench::Way;

// One item: one cell; how many it finds, itself among them.
template <class CellT, class Search>
struct CountNeighbours {
  uint32_t* counts;  // by id
  const CellT* cells;
  Search search;
  float radius;

  GW_BODY void operator()(uint32_t i) const {
    const CellT self = cells[i];
    if (!isLiving(self.x)) return;
    uint32_t count = 0;
    search.around(i, placeOf(self), radius, [&](const CellT&, uint32_t, PlaceOf<CellT>) { ++count; });
    counts[self.id] = count;
  }
};

// One item: one cell; how many pairs it tests for that.
template <class CellT, class Search>
struct CountTests {
  uint64_t* tests;
  const CellT* cells;
  Search search;
  float radius;

  GW_BODY void operator()(uint32_t i) const {
    const CellT self = cells[i];
    tests[i] =
        isLiving(self.x) ? search.around(i, placeOf(self), radius, [](const CellT&, uint32_t, PlaceOf<CellT>) {}) : 0;
  }
};

// One item: one entity's new place, wherever its cell is.
template <class CellT>
struct MoveTo {
  CellT* cells;
  const uint32_t* cellOf;
  const CellT* byId;
  GW_BODY void operator()(uint32_t id) const { cells[cellOf[id]] = byId[id]; }
};

// What the ways have in common: the cells, in as many as the structure wants, the rest dead.
template <class CellT, class Structure>
class Searcher : public bench::Contender<CellT> {
 public:
  Searcher(const ExecOptions& options, const Place& place, uint32_t n, Structure structure)
      : queue_(options),
        structure_(std::move(structure)),
        entities_(n),
        capacity_(structure_.prepare(queue_, place, n)),
        cells_(queue_, capacity_),
        byId_(queue_, n),
        cellOf_(queue_, capacity_),
        counts_(queue_, n),
        tests_(queue_, capacity_),
        total_(queue_, 1),
        sum_(queue_, capacity_),
        radius_(place.radius) {}

  void start(const std::vector<CellT>& byId) override {
    std::vector<CellT> all = byId;
    all.resize(capacity_);
    std::vector<uint32_t> own(capacity_);
    for (uint32_t i = 0; i < capacity_; ++i) {
      if (i >= entities_) all[i] = deadCell(CellT{}, i);
      own[i] = i;
    }
    cells_.upload(all);
    cellOf_.upload(own);
    structure_.build(queue_, cells_.data(), cellOf_.data());
    queue_.synchronise();
  }
  void move(const std::vector<CellT>& byId) override {
    byId_.upload(byId);
    forEach(queue_, Count{entities_}, MoveTo<CellT>{cells_.data(), cellOf_.data(), byId_.data()});
    queue_.synchronise();
  }
  void maintain() override { structure_.maintain(queue_, cells_.data(), cellOf_.data()); }
  void gather() override {
    withSearch([&](auto search) {
      forEach(queue_, Count{capacity_},
              CountNeighbours<CellT, decltype(search)>{counts_.data(), cells_.data(), search, radius_});
    });
  }
  void synchronise() override { queue_.synchronise(); }
  std::vector<uint32_t> counts() override { return counts_.download(); }
  uint64_t candidates() override {
    withSearch([&](auto search) {
      forEach(queue_, Count{capacity_},
              CountTests<CellT, decltype(search)>{tests_.data(), cells_.data(), search, radius_});
    });
    sum_.run(queue_, tests_.data(), total_.data());
    return total_.download()[0];
  }
  size_t bytes() const override { return structure_.bytes() + (capacity_ - entities_) * sizeof(CellT); }

 private:
  template <class Launch>
  void withSearch(const Launch& launch) {
    launch(structure_.search(cells_.data()));
  }

  Queue queue_;
  Structure structure_;
  uint32_t entities_, capacity_;
  Buffer<CellT> cells_, byId_;
  Buffer<uint32_t> cellOf_, counts_;
  Buffer<uint64_t> tests_, total_;
  Reduce sum_;
  float radius_;
};

template <class CellT>
struct Brute {
  uint32_t count = 0;
  uint32_t prepare(Queue&, const Place&, uint32_t n) { return count = n; }
  void build(Queue&, CellT*, uint32_t*) {}
  void maintain(Queue&, CellT*, uint32_t*) {}
  BruteForce<CellT> search(const CellT* cells) const { return {cells, count}; }
  size_t bytes() const { return 0; }
};

template <class CellT>
struct Bin {
  int perRadius;  // bins along a radius
  UniformGrid<CellT> grid{};
  uint32_t prepare(Queue& queue, const Place& place, uint32_t n) {
    const float size = place.radius / float(perRadius);
    if constexpr (sizeof(PlaceOf<CellT>) == sizeof(Float2)) {
      grid = {queue, n, binsOver(Float2{0, 0}, Float2{place.world[0], place.world[1]}, size, n)};
    } else {
      grid = {queue, n, binsOver(Float3{0, 0, 0}, Float3{place.world[0], place.world[1], place.world[2]}, size, n)};
    }
    return n;
  }
  void build(Queue& queue, CellT* cells, uint32_t* cellOf) { grid.maintain(queue, cells, cellOf); }
  void maintain(Queue& queue, CellT* cells, uint32_t* cellOf) { grid.maintain(queue, cells, cellOf); }
  GridGather<CellT> search(const CellT* cells) const { return grid.view(cells); }
  size_t bytes() const { return grid.bytes(); }
};

template <class CellT>
struct Hash {
  HashedGrid<CellT> grid{};
  uint32_t prepare(Queue& queue, const Place& place, uint32_t n) {
    grid = {queue, n, place.radius};
    return n;
  }
  void build(Queue& queue, CellT* cells, uint32_t*) { grid.maintain(queue, cells); }
  void maintain(Queue& queue, CellT* cells, uint32_t*) { grid.maintain(queue, cells); }
  HashedGather<CellT> search(const CellT* cells) const { return grid.view(cells); }
  size_t bytes() const { return grid.bytes(); }
};

template <class CellT>
Float3 sizeOf(const Place& place) {
  return {place.world[0], place.world[1], kFlat<CellT> ? 0.0f : place.world[2]};
}

enum class Upkeep { bitonic, full, packed, frozen };

template <class CellT>
struct Rows {
  Upkeep upkeep;
  NGrid<CellT> grid{};
  uint32_t prepare(Queue& queue, const Place& place, uint32_t n) {
    const bool inPlace = upkeep == Upkeep::bitonic || upkeep == Upkeep::full;
    grid = {queue, chooseDimensions(n, sizeOf<CellT>(place), place.radius), inPlace ? Kept::inPlace : Kept::packed};
    return grid.dimensions().cells();
  }
  void build(Queue& queue, CellT* cells, uint32_t* cellOf) { grid.rebuild(queue, cells, cellOf); }
  void maintain(Queue& queue, CellT* cells, uint32_t* cellOf) {
    switch (upkeep) {
      case Upkeep::bitonic:
        return grid.maintain(queue, cells, cellOf);
      case Upkeep::full:
        return grid.rebuild(queue, cells, cellOf);
      case Upkeep::packed:
        return grid.pack(queue, cells, cellOf);
      case Upkeep::frozen:
        return grid.rowsWidened() > kWorthRebuilding ? grid.pack(queue, cells, cellOf)
                                                     : grid.refresh(queue, cells, cellOf);
    }
  }
  RowGather<CellT> search(const CellT* cells) const { return {grid.view(cells)}; }
  size_t bytes() const { return grid.bytes(); }
};

template <class CellT, template <class> class Gather>
struct Window {
  bool oddEven;
  NGrid<CellT> grid{};
  uint32_t prepare(Queue& queue, const Place& place, uint32_t n) {
    grid = {queue, chooseWindowDimensions(n, sizeOf<CellT>(place))};
    return grid.dimensions().cells();
  }
  void build(Queue& queue, CellT* cells, uint32_t* cellOf) { grid.settle(queue, cells, cellOf); }
  void maintain(Queue& queue, CellT* cells, uint32_t* cellOf) {
    if (oddEven) return grid.transpose(queue, cells, cellOf);
    grid.maintain(queue, cells, cellOf);
  }
  Gather<CellT> search(const CellT* cells) const { return {grid.view(cells)}; }
  size_t bytes() const { return grid.bytes(); }
};

template <class CellT>
struct Choice {
  Way way;
  std::unique_ptr<bench::Contender<CellT>> (*make)(const ExecOptions&, const Place&, uint32_t n);
};

template <class CellT, class Structure, auto... kHow>
std::unique_ptr<bench::Contender<CellT>> make(const ExecOptions& options, const Place& place, uint32_t n) {
  return std::make_unique<Searcher<CellT, Structure>>(options, place, n, Structure{kHow...});
}

constexpr uint32_t kAny = ~0u, kSlow = 1u << 16;

template <class CellT>
std::vector<Choice<CellT>> choices() {
  return {
      {{"grid", true, kAny}, make<CellT, Bin<CellT>, 1>},
      {{"grid, half bins", true, kAny}, make<CellT, Bin<CellT>, 2>},
      {{"grid, hashed", true, kAny}, make<CellT, Hash<CellT>>},
      {{"ngrid, bitonic", true, kAny}, make<CellT, Rows<CellT>, Upkeep::bitonic>},
      {{"ngrid, full sort", true, kAny}, make<CellT, Rows<CellT>, Upkeep::full>},
      {{"ngrid, packed", true, kAny}, make<CellT, Rows<CellT>, Upkeep::packed>},
      {{"ngrid, frozen rows", true, kAny}, make<CellT, Rows<CellT>, Upkeep::frozen>},
      {{"thesis: fixed 4, bitonic", false, kAny}, make<CellT, Window<CellT, FixedGather>, false>},
      {{"thesis: fixed 4, odd-even", false, kAny}, make<CellT, Window<CellT, FixedGather>, true>},
      {{"thesis: adaptive, bitonic", false, kAny}, make<CellT, Window<CellT, AdaptiveGather>, false>},
      {{"thesis: adaptive, odd-even", false, kAny}, make<CellT, Window<CellT, AdaptiveGather>, true>},
      {{"brute force", true, kSlow}, make<CellT, Brute<CellT>>},
  };
}
const std::vector<Choice<Cell>> kWays2 = choices<Cell>();
const std::vector<Choice<Cell3>> kWays3 = choices<Cell3>();

template <class CellT>
std::vector<Way> waysOf(const std::vector<Choice<CellT>>& choices) {
  std::vector<Way> ways;
  for (const Choice<CellT>& choice : choices) ways.push_back(choice.way);
  return ways;
}

}  // namespace

std::vector<Way> ways2() {
  return waysOf(kWays2);
}
std::vector<Way> ways3() {
  return waysOf(kWays3);
}
std::unique_ptr<bench::Contender<Cell>> makeContender2(size_t way, const ExecOptions& options, const Place& place,
                                                       uint32_t n) {
  return kWays2.at(way).make(options, place, n);
}
std::unique_ptr<bench::Contender<Cell3>> makeContender3(size_t way, const ExecOptions& options, const Place& place,
                                                        uint32_t n) {
  return kWays3.at(way).make(options, place, n);
}

}  // namespace gw::GW_DEVICE
