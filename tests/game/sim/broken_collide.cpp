#include "tests/game/sim/broken_collide.h"

#include <optional>

// Everything that collide.cu includes, so that the renaming below meets its own text alone.
#include "game/sim/contact/overlap.h"
#include "game/sim/contact/sweep.h"
#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"
#include "gpu/math/fixed_sum.h"

namespace gw::cpu {
namespace {

Break breakage = Break::nothing;

template <class Search>
struct Broken {
  Search search;

  template <class Visitor>
  uint32_t around(uint32_t index, Float2 at, float radius, Visitor&& visit) const {
    return broken(radius, visit, [&](float r, const auto& see) { return search.around(index, at, r, see); });
  }

  template <class Visitor>
  uint32_t after(uint32_t index, Float2 at, float radius, Visitor&& visit) const {
    return broken(radius, visit, [&](float r, const auto& see) { return search.after(index, at, r, see); });
  }

 private:
  template <class Visitor, class Look>
  static uint32_t broken(float radius, Visitor&& visit, const Look& look) {
    if (breakage == Break::shortRadius) return look(0.7f * radius, visit);
    if (breakage == Break::shortByHalf) return look(radius - 0.5f, visit);
    if (breakage == Break::nothing) return look(radius, visit);
    struct Found {
      Cell cell;
      uint32_t place;
      Float2 away;
    };
    std::optional<Found> held;  // one behind: the last is never handed on
    return look(radius, [&](const Cell& cell, uint32_t place, Float2 away) {
      if (held) visit(held->cell, held->place, held->away);
      held = Found{cell, place, away};
    });
  }
};

template <class Launch>
void withBrokenSearch(const Searches& near, const Launch& launch) {
  withSearch(near, [&](auto search) { launch(Broken<decltype(search)>{search}); });
}

}  // namespace
}  // namespace gw::cpu

#define collide collideBySearch
#define withSearch withBrokenSearch
#include "game/sim/collide.cu"
#undef collide
#undef withSearch

namespace gw::cpu {

void brokenCollide(Queue& queue, const View& view, Break how) {
  breakage = how;
  collideBySearch(queue, view);
}

}  // namespace gw::cpu
