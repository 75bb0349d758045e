// Counting neighbours by every way of gpu/, behind one face.
#include <stdexcept>
#include <utility>

#include "bench/neighbours/contender.h"
#include "bench/neighbours/structures.h"
#include "gpu/math/state_hash.h"
#include "gpu/primitives/scan_reduce.h"

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

// One item: one cell; the hashes of the ids that it finds, added up, so that no order of visits matters.
template <class CellT, class Search>
struct IdentifyNeighbours {
  uint64_t* identities;  // by id
  const CellT* cells;
  Search search;
  float radius;

  GW_BODY void operator()(uint32_t i) const {
    const CellT self = cells[i];
    if (!isLiving(self.x)) return;
    uint64_t sum = 0;
    search.around(i, placeOf(self), radius,
                  [&](const CellT& other, uint32_t, PlaceOf<CellT>) { sum += hashWord(self.id, 0, other.id); });
    identities[self.id] = sum;
  }
};

// One item: one cell, the next is some further on; how many pairs it tests for that.
template <class CellT, class Search>
struct CountTests {
  uint64_t* tests;
  const CellT* cells;
  Search search;
  float radius;
  uint32_t toNext;

  GW_BODY void operator()(uint32_t item) const {
    const uint32_t i = item * toNext;
    const CellT self = cells[i];
    tests[i] =
        isLiving(self.x) ? search.around(i, placeOf(self), radius, [](const CellT&, uint32_t, PlaceOf<CellT>) {}) : 0;
  }
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
    ways::fill(cells_, cellOf_, byId);
    structure_.build(queue_, cells_.data(), cellOf_.data());
    queue_.synchronise();
  }
  void move(const std::vector<CellT>& byId) override {
    byId_.upload(byId);
    forEach(queue_, Count{entities_}, ways::MoveTo<CellT>{cells_.data(), cellOf_.data(), byId_.data()});
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
  std::vector<uint64_t> identities() override {
    withSearch([&](auto search) {
      forEach(queue_, Count{capacity_},
              IdentifyNeighbours<CellT, decltype(search)>{tests_.data(), cells_.data(), search, radius_});
    });
    std::vector<uint64_t> byId = tests_.download();
    byId.resize(entities_);
    return byId;
  }
  void probe(uint32_t every) override { countTests(every); }
  uint64_t candidates() override {
    countTests(1);
    sum_.run(queue_, tests_.data(), total_.data());
    return total_.download()[0];
  }
  std::optional<uint32_t> misaligned() override { return structure_.misaligned(queue_, cells_.data()); }
  size_t bytes() const override { return structure_.bytes() + (capacity_ - entities_) * sizeof(CellT); }

 private:
  template <class Launch>
  void withSearch(const Launch& launch) {
    launch(structure_.search(cells_.data()));
  }

  void countTests(uint32_t every) {
    withSearch([&](auto search) {
      forEach(queue_, Count{capacity_ / every},
              CountTests<CellT, decltype(search)>{tests_.data(), cells_.data(), search, radius_, every});
    });
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
std::unique_ptr<bench::Contender<CellT>> make(size_t way, const ExecOptions& options, const Place& place, uint32_t n) {
  std::unique_ptr<bench::Contender<CellT>> made;
  size_t number = 0;
  ways::forEachWay<CellT>([&](const Way&, auto structure) {
    if (number++ != way) return;
    made = std::make_unique<Searcher<CellT, decltype(structure)>>(options, place, n, std::move(structure));
  });
  if (!made) throw std::out_of_range("There is no such way.");
  return made;
}

}  // namespace

std::vector<Way> ways2() {
  return ways::waysOf<Cell>();
}
std::vector<Way> ways3() {
  return ways::waysOf<Cell3>();
}
std::unique_ptr<bench::Contender<Cell>> makeContender2(size_t way, const ExecOptions& options, const Place& place,
                                                       uint32_t n) {
  return make<Cell>(way, options, place, n);
}
std::unique_ptr<bench::Contender<Cell3>> makeContender3(size_t way, const ExecOptions& options, const Place& place,
                                                        uint32_t n) {
  return make<Cell3>(way, options, place, n);
}

}  // namespace gw::GW_DEVICE
