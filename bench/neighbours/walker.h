// A crowd that walks by a rule that depends on neighbours, so that missed ones change where the walkers end.
#pragma once

#include <memory>
#include <vector>

#include "bench/neighbours/contender.h"

namespace gw::bench {

// Every walker has a goal and is pushed by all others within the radius.
struct WalkRule {
  float radius;      // m
  float step_s;      // of time that one step takes
  float speed_mps;   // the wanted speed, and at most half as much again
  float reaction_s;  // in which a velocity turns into the wanted one
  float push_mps2;   // of a neighbour that stands in the same place; falls to none at the radius
};

template <class CellT>
class Walker {
 public:
  virtual ~Walker() = default;
  virtual void start(const std::vector<CellT>& byId, const std::vector<CellT>& goals) = 0;  // at rest
  virtual void step() = 0;                                                                  // upkeep, then motion
  virtual void synchronise() = 0;           // waits until all that was asked for is done
  virtual std::vector<CellT> places() = 0;  // by id
};

}  // namespace gw::bench

// Their numbers are those of the ways of contender.h.
namespace gw::cpu {
std::unique_ptr<bench::Walker<Cell>> makeWalker2(size_t way, const ExecOptions&, const bench::Place&, uint32_t n,
                                                 const bench::WalkRule&);
std::unique_ptr<bench::Walker<Cell3>> makeWalker3(size_t way, const ExecOptions&, const bench::Place&, uint32_t n,
                                                  const bench::WalkRule&);
}  // namespace gw::cpu
#ifdef GW_HAVE_CUDA
namespace gw::cuda {
std::unique_ptr<bench::Walker<Cell>> makeWalker2(size_t way, const ExecOptions&, const bench::Place&, uint32_t n,
                                                 const bench::WalkRule&);
std::unique_ptr<bench::Walker<Cell3>> makeWalker3(size_t way, const ExecOptions&, const bench::Place&, uint32_t n,
                                                  const bench::WalkRule&);
}  // namespace gw::cuda
#endif
