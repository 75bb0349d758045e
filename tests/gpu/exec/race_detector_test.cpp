// The race detector detects: kernels with a planted race give what their author expected when one thread
// goes forward, and something else in another order. One thread throughout, so the result is certain.
#include <gtest/gtest.h>

#include "gpu/exec/buffer.h"

namespace gw::cpu {
namespace {

constexpr uint32_t kItems = 1000;

// Reads what another item of the same launch writes.
struct RacyItems {
  uint32_t* out;
  void operator()(uint32_t i) const { out[i] = i ? out[i - 1] + 1 : 1; }
};

// Takes the next slot in the order of arrival.
struct RacySlots {
  uint32_t* next;
  uint32_t* out;
  void operator()(uint32_t i) const { out[(*next)++] = i; }
};

// Reads what another lane of the same phase writes: a phase boundary is missing.
struct RacyPhase {
  static constexpr uint32_t kLanes = 128;
  struct Shared {
    uint32_t word[kLanes] = {};
  };
  uint32_t* out;
  template <class Team>
  void operator()(const Team& team, Shared& s) const {
    team.phase([&](uint32_t lane) {
      s.word[lane] = lane;
      out[team.index * kLanes + lane] = lane ? s.word[lane - 1] : 0;
    });
  }
};

// Teams that read each other's results.
struct RacyTeams {
  static constexpr uint32_t kLanes = 32;
  struct Shared {};
  uint32_t* out;
  template <class Team>
  void operator()(const Team& team, Shared&) const {
    team.phase([&](uint32_t lane) {
      if (lane == 0) out[team.index] = team.index ? out[team.index - 1] + 1 : 1;
    });
  }
};

template <class Launch>
std::vector<uint32_t> run(VisitOrder order, const Launch& launch) {
  Queue queue({1, order});
  Buffer<uint32_t> out(queue, kItems + 1);
  launch(queue, out.data());
  return out.download();
}

template <class Launch>
void expectCaught(const Launch& launch) {
  const auto forward = run(VisitOrder::forward, launch);
  EXPECT_EQ(run(VisitOrder::forward, launch), forward);
  EXPECT_NE(run(VisitOrder::reversed, launch), forward);
  EXPECT_NE(run(VisitOrder::shuffled, launch), forward);
}

TEST(RaceDetector, CatchesItemsThatReadEachOther) {
  expectCaught([](Queue& queue, uint32_t* out) { forEach(queue, Count{kItems}, RacyItems{out}); });
}

TEST(RaceDetector, CatchesSlotsInOrderOfArrival) {
  expectCaught([](Queue& queue, uint32_t* out) { forEach(queue, Count{kItems}, RacySlots{out + kItems, out}); });
}

TEST(RaceDetector, CatchesAMissingPhaseBoundary) {
  expectCaught([](Queue& queue, uint32_t* out) { forEachTeam(queue, 7, RacyPhase{out}); });
}

TEST(RaceDetector, CatchesTeamsThatReadEachOther) {
  expectCaught([](Queue& queue, uint32_t* out) { forEachTeam(queue, 100, RacyTeams{out}); });
}

}  // namespace
}  // namespace gw::cpu
