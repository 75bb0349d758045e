// Ways to find neighbours that are not ours, or not for GPUs: what people would take instead. Host code, on as many
// threads as the others.
//
//   k-d tree         nanoflann, rebuilt each frame; misses pairs whose distance its bounds round away
//   hashed lists     as CompactNSearch works: a map from bins to entities, and a list of neighbours for each entity
//   sweep and prune  all sorted by x, each looks both ways until x is out of reach
//   quadtree         (in 3D octree) split until few are left, rebuilt each frame
#pragma once

#include "bench/neighbours/contender.h"

namespace gw::bench {

std::vector<Way> outsiders();
template <class CellT>
std::unique_ptr<Contender<CellT>> makeOutsider(size_t way, const ExecOptions& options, const Place& place, uint32_t n);

}  // namespace gw::bench
