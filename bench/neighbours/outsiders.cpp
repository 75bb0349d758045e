#include "bench/neighbours/outsiders.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <nanoflann.hpp>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>

#include "gpu/exec/worker_pool.h"

namespace gw::bench {
namespace {

template <class CellT>
constexpr int kAxes = std::is_same_v<CellT, Cell3> ? 3 : 2;

inline float axis(const Cell& cell, int which) {
  return which == 0 ? cell.x : cell.y;
}
inline float axis(const Cell3& cell, int which) {
  return which == 0 ? cell.x : which == 1 ? cell.y : cell.z;
}

// The neighbour test of gpu/neighbours/neighbour.h: the same float operations in the same order.
template <class CellT>
bool near(const CellT& a, const CellT& b, float radius) {
  float sum = 0.0f;
  bool within = true;
  for (int k = 0; k < kAxes<CellT>; ++k) {
    const float d = axis(b, k) - axis(a, k);
    sum = k == 0 ? d * d : sum + d * d;
    within &= std::fabs(d) <= radius;
  }
  return within && sum <= radius * radius;
}

// All queries run on the pool, a chunk at a time.
template <class CellT>
class Outsider : public Contender<CellT> {
 public:
  Outsider(const ExecOptions& options, const Place& place, uint32_t n)
      : pool_(options.threads), counts_(n), radius_(place.radius) {}

  void start(const std::vector<CellT>& byId) override {
    cells_ = byId;
    maintain();
  }
  void move(const std::vector<CellT>& byId) override { cells_ = byId; }
  void maintain() override { build(); }
  void gather() override {
    tests_ = 0;
    struct Job {
      Outsider& self;
      uint32_t n;
    } job{*this, uint32_t(cells_.size())};
    pool_.run((job.n + kChunk - 1) / kChunk,
              [](const void* context, uint32_t chunk) {
                const Job& job = *static_cast<const Job*>(context);
                uint64_t tests = 0;
                for (uint32_t i = chunk * kChunk; i < std::min(job.n, (chunk + 1) * kChunk); ++i) {
                  job.self.counts_[i] = job.self.ask(i, tests);
                }
                job.self.tests_ += tests;
              },
              &job);
  }
  void synchronise() override {}
  std::vector<uint32_t> counts() override { return counts_; }
  uint64_t candidates() override { return tests_; }

 protected:
  virtual void build() = 0;
  virtual uint32_t ask(uint32_t id, uint64_t& tests) = 0;  // how many neighbours, itself among them

  static constexpr uint32_t kChunk = 256;
  WorkerPool pool_;
  std::vector<CellT> cells_;
  std::vector<uint32_t> counts_;
  std::atomic<uint64_t> tests_{0};
  float radius_;
};

template <class CellT>
class KdTree final : public Outsider<CellT> {
 public:
  using Outsider<CellT>::Outsider;
  // What nanoflann asks of a set of points.
  size_t kdtree_get_point_count() const { return this->cells_.size(); }
  float kdtree_get_pt(size_t i, size_t which) const { return axis(this->cells_[i], int(which)); }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
  size_t bytes() const override { return tree_ ? tree_->usedMemory(*tree_) : 0; }

 private:
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, KdTree>, KdTree, kAxes<CellT>, uint32_t>;
  struct Count {
    using DistanceType = float;
    using IndexType = uint32_t;
    float radius2;
    uint32_t found = 0;
    uint64_t tests = 0;
    bool addPoint(float distance2, uint32_t) {
      found += distance2 <= radius2;
      return true;
    }
    float worstDist() const { return std::nextafter(radius2, INFINITY); }
    bool full() const { return true; }
    size_t size() const { return found; }
    void sort() {}  // asked for since nanoflann 1.6: a count has no order
  };

  void build() override { tree_ = std::make_unique<Tree>(kAxes<CellT>, *this); }
  uint32_t ask(uint32_t id, uint64_t& tests) override {
    float at[3];
    for (int k = 0; k < kAxes<CellT>; ++k) at[k] = axis(this->cells_[id], k);
    Count count{this->radius_ * this->radius_};
    tree_->findNeighbors(count, at, {});  // the usual parameters, whose type has another name since nanoflann 1.5
    tests += count.found;                 // nanoflann does not say how many it tests: at least these
    return count.found;
  }
  std::unique_ptr<Tree> tree_;
};

template <class CellT>
class HashedLists final : public Outsider<CellT> {
 public:
  using Outsider<CellT>::Outsider;
  size_t bytes() const override {
    size_t sum = bins_.size() * (sizeof(Bin) + sizeof(std::vector<uint32_t>));
    for (const auto& [bin, members] : bins_) sum += members.capacity() * sizeof(uint32_t);
    for (const auto& list : lists_) sum += sizeof list + list.capacity() * sizeof(uint32_t);
    return sum + binOf_.size() * sizeof(Bin);
  }

 private:
  using Bin = std::array<int32_t, 3>;
  struct Hash {
    size_t operator()(const Bin& b) const {
      return uint32_t(b[0]) * 73856093u ^ uint32_t(b[1]) * 19349663u ^ uint32_t(b[2]) * 83492791u;
    }
  };
  // A little wider than the radius, so that rounding never hides a neighbour two bins away.
  Bin binFor(const CellT& cell) const {
    Bin bin{};
    for (int k = 0; k < kAxes<CellT>; ++k) {
      bin[size_t(k)] = int32_t(std::floor(double(axis(cell, k)) / (double(this->radius_) * 1.0001)));
    }
    return bin;
  }

  void build() override {
    lists_.resize(this->cells_.size());
    const bool first = binOf_.empty();
    binOf_.resize(this->cells_.size());
    for (uint32_t id = 0; id < this->cells_.size(); ++id) {
      const Bin bin = binFor(this->cells_[id]);
      if (!first && bin == binOf_[id]) continue;
      if (!first) {
        auto& old = bins_[binOf_[id]];
        *std::find(old.begin(), old.end(), id) = old.back();
        old.pop_back();
      }
      bins_[bin].push_back(id);
      binOf_[id] = bin;
    }
  }
  uint32_t ask(uint32_t id, uint64_t& tests) override {
    std::vector<uint32_t>& list = lists_[id];
    list.clear();
    const Bin bin = binOf_[id];
    const int32_t deep = kAxes<CellT> == 3 ? 1 : 0;
    for (int32_t z = -deep; z <= deep; ++z) {
      for (int32_t y = -1; y <= 1; ++y) {
        for (int32_t x = -1; x <= 1; ++x) {
          const auto found = bins_.find({bin[0] + x, bin[1] + y, bin[2] + z});
          if (found == bins_.end()) continue;
          tests += found->second.size();
          for (const uint32_t other : found->second) {
            if (near(this->cells_[id], this->cells_[other], this->radius_)) list.push_back(other);
          }
        }
      }
    }
    return uint32_t(list.size());
  }

  std::unordered_map<Bin, std::vector<uint32_t>, Hash> bins_;
  std::vector<Bin> binOf_;
  std::vector<std::vector<uint32_t>> lists_;
};

template <class CellT>
class SweepAndPrune final : public Outsider<CellT> {
 public:
  using Outsider<CellT>::Outsider;
  size_t bytes() const override { return sorted_.size() * (sizeof(CellT) + 2 * sizeof(uint32_t)); }

 private:
  void build() override {
    if (order_.empty()) {
      for (uint32_t id = 0; id < this->cells_.size(); ++id) order_.push_back(id);
    }
    // The order of the last frame is nearly that of this one.
    std::stable_sort(order_.begin(), order_.end(),
                     [&](uint32_t a, uint32_t b) { return this->cells_[a].x < this->cells_[b].x; });
    sorted_.resize(order_.size());
    rank_.resize(order_.size());
    for (uint32_t i = 0; i < order_.size(); ++i) {
      sorted_[i] = this->cells_[order_[i]];
      rank_[order_[i]] = i;
    }
  }
  uint32_t ask(uint32_t id, uint64_t& tests) override {
    const CellT self = this->cells_[id];
    const size_t here = rank_[id];
    size_t first = here, last = here;
    while (first > 0 && self.x - sorted_[first - 1].x <= this->radius_) --first;
    while (last + 1 < sorted_.size() && sorted_[last + 1].x - self.x <= this->radius_) ++last;
    uint32_t found = 0;
    for (size_t i = first; i <= last; ++i) found += near(self, sorted_[i], this->radius_);
    tests += last - first + 1;
    return found;
  }

  std::vector<uint32_t> order_, rank_;
  std::vector<CellT> sorted_;
};

template <class CellT>
class Quadtree final : public Outsider<CellT> {
 public:
  using Outsider<CellT>::Outsider;
  size_t bytes() const override { return nodes_.size() * sizeof(Node) + sorted_.size() * sizeof(CellT); }

 private:
  static constexpr uint32_t kFew = 12, kDeepest = 20, kChildren = 1u << kAxes<CellT>;
  struct Node {
    float low[3], high[3];  // of those in it
    uint32_t begin, end;    // in sorted_
    uint32_t child;         // the first of kChildren in a row, 0: a leaf
  };

  void build() override {
    sorted_ = this->cells_;
    nodes_.clear();
    nodes_.push_back({});
    split(0, 0, uint32_t(sorted_.size()), 0);
  }

  void split(uint32_t at, uint32_t begin, uint32_t end, uint32_t depth) {
    Node node{};
    for (int k = 0; k < kAxes<CellT>; ++k) {
      node.low[k] = INFINITY;
      node.high[k] = -INFINITY;
      for (uint32_t i = begin; i < end; ++i) {
        node.low[k] = std::min(node.low[k], axis(sorted_[i], k));
        node.high[k] = std::max(node.high[k], axis(sorted_[i], k));
      }
    }
    node.begin = begin;
    node.end = end;
    if (end - begin > kFew && depth < kDeepest) {
      node.child = uint32_t(nodes_.size());
      nodes_.resize(nodes_.size() + kChildren);
    }
    nodes_[at] = node;
    if (!node.child) return;
    uint32_t from = begin;
    for (uint32_t c = 0; c < kChildren; ++c) {
      const auto mine = [&](const CellT& cell) {
        uint32_t which = 0;
        for (int k = 0; k < kAxes<CellT>; ++k) {
          which |= uint32_t(axis(cell, k) > 0.5f * (node.low[k] + node.high[k])) << k;
        }
        return which == c;
      };
      const auto middle = std::partition(sorted_.begin() + from, sorted_.begin() + end, mine);
      const uint32_t to = uint32_t(middle - sorted_.begin());
      split(node.child + c, from, to, depth + 1);
      from = to;
    }
  }

  uint32_t ask(uint32_t id, uint64_t& tests) override {
    const CellT self = this->cells_[id];
    uint32_t stack[kDeepest * kChildren + 1], depth = 0, found = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      bool out = node.begin == node.end;
      for (int k = 0; k < kAxes<CellT>; ++k) {
        out |= node.low[k] - axis(self, k) > this->radius_ || axis(self, k) - node.high[k] > this->radius_;
      }
      if (out) continue;
      if (node.child) {
        for (uint32_t c = 0; c < kChildren; ++c) stack[depth++] = node.child + c;
        continue;
      }
      for (uint32_t i = node.begin; i < node.end; ++i) found += near(self, sorted_[i], this->radius_);
      tests += node.end - node.begin;
    }
    return found;
  }

  std::vector<Node> nodes_;
  std::vector<CellT> sorted_;
};

}  // namespace

std::vector<Way> outsiders() {
  return {{"k-d tree (nanoflann)", false, kAny},
          {"hashed lists", true, kAny},
          {"sweep and prune", true, kSlow},
          {"quadtree", true, kAny}};
}

template <class CellT>
std::unique_ptr<Contender<CellT>> makeOutsider(size_t way, const ExecOptions& options, const Place& place, uint32_t n) {
  switch (way) {
    case 0:
      return std::make_unique<KdTree<CellT>>(options, place, n);
    case 1:
      return std::make_unique<HashedLists<CellT>>(options, place, n);
    case 2:
      return std::make_unique<SweepAndPrune<CellT>>(options, place, n);
    case 3:
      return std::make_unique<Quadtree<CellT>>(options, place, n);
  }
  throw std::out_of_range("There is no such outsider.");
}

template std::unique_ptr<Contender<Cell>> makeOutsider(size_t, const ExecOptions&, const Place&, uint32_t);
template std::unique_ptr<Contender<Cell3>> makeOutsider(size_t, const ExecOptions&, const Place&, uint32_t);

}  // namespace gw::bench
