#include <gpuwars/hashed_grid.h>

#include <cmath>
#include <stdexcept>

namespace gw::GW_DEVICE {
namespace {

template <class CellT>
struct BucketOfCell {
  const CellT* cells;
  uint32_t buckets;
  float perMetre;

  GW_BODY uint32_t operator()(uint32_t i) const {
    const CellT cell = cells[i];
    if (!isLiving(cell.x)) return buckets;
    const auto place = placeOf(cell);
    return bucketOf(hashedBinAlong(place.x, perMetre), hashedBinAlong(place.y, perMetre),
                    hashedBinAlong(heightOf(place), perMetre), buckets);
  }
};

struct MoveIndex {
  uint32_t* index;
  GW_BODY void operator()(uint32_t from, uint32_t to) const { index[to] = from; }
};

float checkedPerMetre(float binSize) {
  if (!(binSize > 0.0f) || !std::isfinite(binSize) || !std::isfinite(1.0f / binSize)) {
    throw std::invalid_argument("The bins of a hashed grid have a finite size above 0 m.");
  }
  return 1.0f / binSize;
}

}  // namespace

template <class CellT>
HashedGrid<CellT>::HashedGrid(Queue& queue, uint32_t count, float binSize)
    : sort_(queue, count, count + 1), index_(queue, count), perMetre_(checkedPerMetre(binSize)) {}

template <class CellT>
void HashedGrid<CellT>::maintain(Queue& queue, const CellT* d_cells) {
  sort_.run(queue, BucketOfCell<CellT>{d_cells, uint32_t(index_.size()), perMetre_}, MoveIndex{index_.data()});
}

template class HashedGrid<Cell>;
template class HashedGrid<Cell3>;

}  // namespace gw::GW_DEVICE
