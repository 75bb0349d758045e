// The rule by which a crowd walks, over every way of gpu/ to find neighbours. Nothing in it depends on the order of
// visits: ways that find the same neighbours give the same positions, bit for bit.
#include <stdexcept>
#include <utility>

#include "bench/neighbours/structures.h"
#include "bench/neighbours/walker.h"
#include "gpu/math/fixed_sum.h"

namespace gw::GW_DEVICE {
namespace {

using bench::Place;
using bench::WalkRule;
using bench::Way;

GW_FN Float3 inSpace(Float2 place) {
  return {place.x, place.y, 0.0f};
}
GW_FN Float3 inSpace(Float3 place) {
  return place;
}
GW_FN Float3 operator+(Float3 a, Float3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
GW_FN Float3 operator*(Float3 a, float factor) {
  return {a.x * factor, a.y * factor, a.z * factor};
}
GW_FN float lengthOf(Float3 a) {
  return sqrtf(a.x * a.x + a.y * a.y + a.z * a.z);
}
GW_FN Cell at(Cell cell, Float3 place) {
  return {place.x, place.y, cell.id, cell.type};
}
GW_FN Cell3 at(Cell3 cell, Float3 place) {
  return {place.x, place.y, place.z, cell.id};
}

constexpr float kPushScale = 0x1p20f;  // terms are at most 1

struct FixedSum3 {
  int64_t x = 0, y = 0, z = 0;
  GW_MEMBER void add(Float3 term, float scale) {
    x += fixedTerm(term.x, scale);
    y += fixedTerm(term.y, scale);
    z += fixedTerm(term.z, scale);
  }
  GW_MEMBER Float3 total(float scale) const { return {float(x) / scale, float(y) / scale, float(z) / scale}; }
};

// One item: one cell; where its agent is after the step.
template <class CellT, class Search>
struct Walk {
  CellT* next;       // by id
  Float3* velocity;  // by id, m/s
  const CellT* goals;
  const CellT* cells;
  Search search;
  WalkRule rule;

  GW_BODY void operator()(uint32_t i) const {
    const CellT self = cells[i];
    if (!isLiving(self.x)) return;
    const Float3 here = inSpace(placeOf(self));
    FixedSum3 pushes;
    search.around(i, placeOf(self), rule.radius, [&](const CellT& other, uint32_t, PlaceOf<CellT> away) {
      if (other.id == self.id) return;
      const Float3 from = inSpace(away);
      const float distance = lengthOf(from);
      const float nearness = distance < rule.radius ? 1.0f - distance / rule.radius : 0.0f;
      // Of two in one place the one with the lower id gives way to the left.
      const Float3 push = distance > 0.0f ? from * (-nearness / distance)
                                          : Float3{self.id < other.id ? -nearness : nearness, 0.0f, 0.0f};
      pushes.add(push, kPushScale);
    });
    const Float3 way = inSpace(placeOf(goals[self.id])) + here * -1.0f;
    const float left = lengthOf(way);
    // Slower over the last radius, so that none circles the goal.
    const Float3 wanted = way * (rule.speed_mps / (left > rule.radius ? left : rule.radius));
    const Float3 now = velocity[self.id];
    Float3 then = now + (wanted + now * -1.0f) * (rule.step_s / rule.reaction_s) +
                  pushes.total(kPushScale) * (rule.push_mps2 * rule.step_s);
    const float speed = lengthOf(then), most = 1.5f * rule.speed_mps;
    if (speed > most) then = then * (most / speed);
    velocity[self.id] = then;
    next[self.id] = at(self, here + then * rule.step_s);
  }
};

template <class CellT, class Structure>
class Walking : public bench::Walker<CellT> {
 public:
  Walking(const ExecOptions& options, const Place& place, uint32_t n, const WalkRule& rule, Structure structure)
      : queue_(options),
        structure_(std::move(structure)),
        entities_(n),
        capacity_(structure_.prepare(queue_, place, n)),
        cells_(queue_, capacity_),
        byId_(queue_, n),
        goals_(queue_, n),
        velocity_(queue_, n),
        cellOf_(queue_, capacity_),
        rule_(rule) {}

  void start(const std::vector<CellT>& byId, const std::vector<CellT>& goals) override {
    ways::fill(cells_, cellOf_, byId);
    goals_.upload(goals);
    velocity_.upload(std::vector<Float3>(entities_, Float3{0.0f, 0.0f, 0.0f}));
    structure_.build(queue_, cells_.data(), cellOf_.data());
    queue_.synchronise();
  }
  void step() override {
    structure_.maintain(queue_, cells_.data(), cellOf_.data());
    const auto search = structure_.search(cells_.data());
    forEach(queue_, Count{capacity_},
            Walk<CellT, std::remove_const_t<decltype(search)>>{byId_.data(), velocity_.data(), goals_.data(),
                                                               cells_.data(), search, rule_});
    forEach(queue_, Count{entities_}, ways::MoveTo<CellT>{cells_.data(), cellOf_.data(), byId_.data()});
  }
  void synchronise() override { queue_.synchronise(); }
  std::vector<CellT> places() override { return byId_.download(); }

 private:
  Queue queue_;
  Structure structure_;
  uint32_t entities_, capacity_;
  Buffer<CellT> cells_, byId_, goals_;
  Buffer<Float3> velocity_;
  Buffer<uint32_t> cellOf_;
  WalkRule rule_;
};

template <class CellT>
std::unique_ptr<bench::Walker<CellT>> make(size_t way, const ExecOptions& options, const Place& place, uint32_t n,
                                           const WalkRule& rule) {
  std::unique_ptr<bench::Walker<CellT>> made;
  size_t number = 0;
  ways::forEachWay<CellT>([&](const Way&, auto structure) {
    if (number++ != way) return;
    made = std::make_unique<Walking<CellT, decltype(structure)>>(options, place, n, rule, std::move(structure));
  });
  if (!made) throw std::out_of_range("There is no such way.");
  return made;
}

}  // namespace

std::unique_ptr<bench::Walker<Cell>> makeWalker2(size_t way, const ExecOptions& options, const Place& place, uint32_t n,
                                                 const WalkRule& rule) {
  return make<Cell>(way, options, place, n, rule);
}
std::unique_ptr<bench::Walker<Cell3>> makeWalker3(size_t way, const ExecOptions& options, const Place& place,
                                                  uint32_t n, const WalkRule& rule) {
  return make<Cell3>(way, options, place, n, rule);
}

}  // namespace gw::GW_DEVICE
