// What the bench asks of a way to find neighbours, on whatever device. All are handed the same places.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/exec/exec_options.h"
#include "gpu/math/plain_types.h"

namespace gw::bench {

template <class CellT>
class Contender {
 public:
  virtual ~Contender() = default;
  virtual void start(const std::vector<CellT>& byId) = 0;  // construction, from an arbitrary arrangement
  virtual void move(const std::vector<CellT>& byId) = 0;   // new places; not timed
  virtual void maintain() = 0;                             // upkeep after motion
  virtual void gather() = 0;                               // counts the neighbours of every entity
  // Searches for one in so many only: to see how long gather() would take. Nothing where that is never too long.
  virtual void probe(uint32_t /*every*/) {}
  virtual void synchronise() = 0;              // waits until all that was asked for is done
  virtual std::vector<uint32_t> counts() = 0;  // by id, of the last gather(); each counts itself
  // By id: the hashes of the neighbours each finds, added up, by a search of its own. Empty where a way only counts.
  virtual std::vector<uint64_t> identities() { return {}; }
  virtual uint64_t candidates() = 0;  // pair tests of one gather
  // How many entities stand before their predecessor on a line of the structure; none where there are no lines.
  virtual std::optional<uint32_t> misaligned() { return {}; }
  virtual size_t bytes() const = 0;  // of memory beyond the array of entities
};

// What all structures may know in advance: the bounds of all positions, and the radius.
struct Place {
  float world[3];
  float radius;
};

struct Way {
  const char* name;
  bool exact;
  // So slow that large crowds are left out: the most entities it is given.
  uint32_t most;
};
inline constexpr uint32_t kAny = ~0u, kSlow = 1u << 16;

// Whether its name holds one of `only`; all are asked when that is empty.
inline bool isAsked(const Way& way, const std::vector<std::string>& only) {
  return only.empty() || std::any_of(only.begin(), only.end(), [&](const std::string& part) {
           return std::string(way.name).find(part) != std::string::npos;
         });
}

}  // namespace gw::bench

// The ways of one device; the numbers of makeContender() are their places in this list.
namespace gw::cpu {
std::vector<bench::Way> ways2();
std::vector<bench::Way> ways3();
std::unique_ptr<bench::Contender<Cell>> makeContender2(size_t way, const ExecOptions&, const bench::Place&, uint32_t n);
std::unique_ptr<bench::Contender<Cell3>> makeContender3(size_t way, const ExecOptions&, const bench::Place&,
                                                        uint32_t n);
}  // namespace gw::cpu
#ifdef GW_HAVE_CUDA
namespace gw::cuda {
std::vector<bench::Way> ways2();
std::vector<bench::Way> ways3();
std::unique_ptr<bench::Contender<Cell>> makeContender2(size_t way, const ExecOptions&, const bench::Place&, uint32_t n);
std::unique_ptr<bench::Contender<Cell3>> makeContender3(size_t way, const ExecOptions&, const bench::Place&,
                                                        uint32_t n);
}  // namespace gw::cuda
#endif
