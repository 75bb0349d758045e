#include <gpuwars/neighbour_lists.h>

#include <stdexcept>
#include <string>

namespace gw::GW_DEVICE {
namespace {

// One item: one id, and one more for the end.
struct CopyBegins {
  uint32_t* begin;
  ScanView before;
  uint32_t cells;
  GW_BODY void operator()(uint32_t id) const { begin[id] = uint32_t(id < cells ? before.before(id) : before.total()); }
};

// One item in all.
struct CopyTotal {
  uint64_t* total;
  ScanView before;
  GW_BODY void operator()(uint32_t) const { *total = before.total(); }
};

}  // namespace

void requireListable(float radius, const void* d_cells) {
  if (!(radius >= 0.0f && radius < kInfinity)) {
    throw std::invalid_argument("The radius of neighbour lists is finite and at least 0 m; it was " +
                                std::to_string(radius) + ".");
  }
  if (!d_cells) throw std::invalid_argument("d_cells is null; give the cells that are searched.");
}

NeighbourLists::NeighbourLists(Queue& queue, uint32_t cells, uint32_t capacity) : cells_(cells) {
  if (cells == 0) throw std::invalid_argument("Neighbour lists are for at least 1 cell; cells was 0.");
  counts_ = Buffer<uint64_t>(queue, cells);
  before_ = Scan(queue, cells);
  begin_ = Buffer<uint32_t>(queue, size_t(cells) + 1);
  neighbours_ = Buffer<uint32_t>(queue, capacity);
}

std::vector<uint32_t> NeighbourLists::downloadNeighbours() const {
  std::vector<uint32_t> ids(total_);
  neighbours_.download(ids.data(), total_);
  return ids;
}

size_t NeighbourLists::bytes() const {
  return (begin_.size() + neighbours_.size()) * sizeof(uint32_t) + 2 * counts_.size() * sizeof(uint64_t);
}

void NeighbourLists::addUp(Queue& queue) {
  before_.run(queue, counts_.data());
  Buffer<uint64_t> total(queue, 1);
  forEach(queue, Count{1}, CopyTotal{total.data(), before_.view()});
  const uint64_t found = total.download()[0];
  if (found > neighbours_.size()) {
    throw std::length_error("There are " + std::to_string(found) + " neighbours to list and room for " +
                            std::to_string(neighbours_.size()) + "; make the lists with a larger capacity.");
  }
  total_ = uint32_t(found);
  forEach(queue, Count{cells_ + 1}, CopyBegins{begin_.data(), before_.view(), cells_});
}

}  // namespace gw::GW_DEVICE
