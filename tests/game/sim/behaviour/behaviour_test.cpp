// What players see enemies do, measured in the running game: groups form, bullets are dodged, the tricky
// flee and come back whole. Each has a control in which it must not happen.
#include <gtest/gtest.h>

#include <random>

#include "game/sim/entity_flags.h"
#include "tests/game/sim/behaviour/scene.h"

namespace gw::test {
namespace {

std::string typeName(const testing::TestParamInfo<uint32_t>& info) {
  constexpr const char* kNames[] = {"triangle", "quad", "hexagon", "vertex", "texel", "fragment", "compute"};
  return kNames[info.param];
}

// 200 of a type scattered over the world, the ship out of sight in a corner. Nothing draws them together but
// their kind: wandering does not lean to the ship.
struct Scattered {
  double before_m, after_m;  // mean distance to the nearest of its kind
};
Scattered scatter(SimulationConfig config, uint32_t type) {
  config.rules.enemies[type].sight_m = 0;
  config.rules.steering.wanderToShip = 0;
  std::mt19937_64 random(11);
  std::vector<Place> places;
  for (uint32_t i = 0; i < 200; ++i) {
    const float x = 3 + float(random() % 186'000) / 1000, y = 3 + float(random() % 102'000) / 1000;
    places.push_back({type, x, y});
  }
  const auto simulation = makeScene(config, 1, 1, places);
  const double before = meanNearest_m(simulation->snapshot(), type);
  playOn(*simulation, 20 * kTicksPerSecond);
  return {before, meanNearest_m(simulation->snapshot(), type)};
}

class groups : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(of, groups, testing::Values(kVertex, kTexel, kFragment, kCompute), typeName);

TEST_P(groups, form_within_20_s) {
  const Scattered s = scatter(quietConfig(), GetParam());
  EXPECT_LT(s.after_m, 0.5 * s.before_m) << "from " << s.before_m << " m";
}

TEST_P(groups, do_not_form_of_those_who_see_nobody) {
  SimulationConfig config = quietConfig();
  config.rules.enemies[GetParam()].vision_m = 0.01f;
  const Scattered s = scatter(config, GetParam());
  EXPECT_GT(s.after_m, 0.8 * s.before_m) << "from " << s.before_m << " m";
}

TEST_P(groups, do_not_form_of_kamikazes) {
  SimulationConfig config = quietConfig();
  config.rules.enemies[GetParam()].machine = Machine::kamikaze;
  const Scattered s = scatter(config, GetParam());
  EXPECT_GT(s.after_m, 0.8 * s.before_m) << "from " << s.before_m << " m";
}

// Where the fire goes: straight along +x, or at the enemy wherever it is.
enum class Fire { straight, aimed };

uint16_t aimAt(double x, double y) {
  return uint16_t(std::lround(std::atan2(y, x) / (2 * 3.14159265358979) * 65536));
}

// The ship stands still and fires at enemies that come at it from +x, one after the other: so none stands in for
// another. Each bears more than it can be dealt, so that the energy it lost counts its hits. Hits per shot.
double hitRate(SimulationConfig config, uint32_t type, Machine machine, Fire fire) {
  constexpr float kShip_x = 40, kShip_y = 54, kEnergy = 1000;
  EnemyRules& rules = config.rules.enemies[type];
  rules.machine = machine;
  rules.energy = kEnergy;
  rules.sight_m = 1000;
  config.rules.shot.knockBack_mps = 0;
  uint64_t shots = 0;
  double hits = 0;
  for (uint32_t trial = 0; trial < 12; ++trial) {
    const float x = kShip_x + 20 + float(trial), y = kShip_y - 0.5f + float(trial) / 11;
    const auto simulation = makeScene(config, kShip_x, kShip_y, {{type, x, y, 0, State::attacking}});
    InputRecord input;
    input.buttons = kButtonFire;
    EntityRecord enemy{};
    for (uint32_t t = 0; t < 120; ++t) {
      enemy = simulation->snapshot().entities.front();
      if (fire == Fire::aimed) input.aim = aimAt(enemy.x - kShip_x, enemy.y - kShip_y);
      const TickReport report = playOn(*simulation, 1, input);
      if (report.sounds[uint32_t(SoundEvent::shot)][1]) shots += config.rules.shot.levels[0].count;
    }
    hits += kEnergy - enemy.energy;
  }
  return hits / double(shots);
}

class bullets : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(by, bullets, testing::Values(kVertex, kTexel, kFragment, kCompute), typeName);

TEST_P(bullets, along_one_line_are_dodged) {
  const SimulationConfig config = quietConfig();
  const Machine own = config.rules.enemies[GetParam()].machine;
  const double control = hitRate(config, GetParam(), Machine::kamikaze, Fire::straight);
  EXPECT_GT(control, 0.5);
  EXPECT_LT(hitRate(config, GetParam(), own, Fire::straight), 0.5 * control);
}

// No enemy dodges for ever: aimed fire hits while the cooldown lasts. The tricky come straight here, so that it is
// their dodging which is measured.
TEST_P(bullets, that_are_aimed_hit_less) {
  SimulationConfig config = quietConfig();
  config.rules.steering.sideways = 0;
  const Machine own = config.rules.enemies[GetParam()].machine;
  const double control = hitRate(config, GetParam(), Machine::kamikaze, Fire::aimed);
  const double dodging = hitRate(config, GetParam(), own, Fire::aimed);
  EXPECT_GT(control, 0.5);
  EXPECT_LT(dodging, 0.85 * control);
  EXPECT_GT(dodging, 0.1);
}

// What a damaged one goes through, the ship standing still 15 m away.
struct Flight {
  double farthest_m = 0;  // from the ship, while escaping
  uint32_t escaped_ticks = 0;
  float left_energy = 0;  // when it stopped escaping
  uint32_t edges[kStates][kStates] = {};
};
Flight flee(const SimulationConfig& config, uint32_t type, float energy) {
  constexpr float kShip_x = 60, kShip_y = 54;
  const auto simulation =
      makeScene(config, kShip_x, kShip_y, {{type, kShip_x + 15, kShip_y, energy, State::attacking, kFlagHit}});
  Flight flight;
  for (uint32_t t = 0; t < 20 * kTicksPerSecond; ++t) {
    const TickReport report = playOn(*simulation, 1);
    for (uint32_t from = 0; from < kStates; ++from) {
      for (uint32_t to = 0; to < kStates; ++to) {
        flight.edges[from][to] += report.edges.taken[uint32_t(config.rules.enemies[type].machine)][from][to];
      }
    }
    const EntityRecord e = simulation->snapshot().entities.front();
    if (e.state == uint32_t(State::escaping)) {
      ++flight.escaped_ticks;
      flight.farthest_m = std::max(flight.farthest_m, std::hypot(double(e.x) - kShip_x, double(e.y) - kShip_y));
    } else if (flight.escaped_ticks > 0) {
      flight.left_energy = e.energy;
      break;
    }
  }
  return flight;
}

class tricky : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(of, tricky, testing::Values(kFragment, kCompute), typeName);

TEST_P(tricky, flees_recovers_and_returns) {
  const SimulationConfig config = quietConfig();
  const EnemyRules& rules = config.rules.enemies[GetParam()];
  const Rules::Steering& steering = config.rules.steering;
  const float wounded = 0.9f * steering.escapeBelow * rules.energy;
  const Flight flight = flee(config, GetParam(), wounded);
  const double takes_s = (steering.recoveredAt * rules.energy - wounded) / steering.recover_per_s;
  EXPECT_EQ(flight.edges[uint32_t(State::attacking)][uint32_t(State::checkingEnergy)], 1u);
  EXPECT_EQ(flight.edges[uint32_t(State::checkingEnergy)][uint32_t(State::escaping)], 1u);
  EXPECT_EQ(flight.edges[uint32_t(State::escaping)][uint32_t(State::wandering)], 1u);
  EXPECT_NEAR(flight.escaped_ticks, takes_s * kTicksPerSecond, 3);
  EXPECT_GT(flight.farthest_m, 15 + 0.5 * takes_s * rules.speed_mps);
  EXPECT_NEAR(flight.left_energy, steering.recoveredAt * rules.energy, 0.05);
}

TEST_P(tricky, does_not_flee_from_a_scratch) {
  const SimulationConfig config = quietConfig();
  const float scratched = 1.1f * config.rules.steering.escapeBelow * config.rules.enemies[GetParam()].energy;
  EXPECT_EQ(flee(config, GetParam(), scratched).escaped_ticks, 0u);
}

TEST(tricky, is_the_only_one_that_flees) {
  SimulationConfig config = quietConfig();
  for (const Machine machine : {Machine::kamikaze, Machine::group}) {
    config.rules.enemies[kCompute].machine = machine;
    EXPECT_EQ(flee(config, kCompute, 1).escaped_ticks, 0u) << nameOf(machine);
  }
}

}  // namespace
}  // namespace gw::test
