// Entities to find neighbours among: where they stand, how they move, and how far they look.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gpu/math/plain_types.h"

namespace gw::bench {

enum class Distribution : uint32_t {
  uniform,   // all over the world
  clusters,  // 32 Gaussian heaps
  swarm,     // 70 % around one place, the rest all over
  line,      // all at one height
  pairs,     // uniform, two at each place
};
inline constexpr const char* kDistributions[] = {"uniform", "clusters", "swarm", "line", "pairs"};

// About so many others within the radius of each, on average.
inline constexpr double kNeighbours = 20.0;

// CellT is Cell or Cell3. Every entity flies straight on and bounces off the world's walls.
template <class CellT>
struct Crowd {
  std::vector<CellT> byId;
  float radius = 0.0f;      // m, such that the mean number of others within it is near kNeighbours at the start
  float world[3] = {};      // m, from the origin; the third is 0 in 2D
  double neighbours = 0.0;  // the mean number really found at the start

  Crowd(uint32_t n, Distribution distribution, uint64_t seed);
  // One frame: every entity by `radii` times the radius.
  void step(float radii);

 private:
  std::vector<Float3> heading;  // unit vectors
};

}  // namespace gw::bench
