// A bullet never passes through an enemy, at any speed: the sweep against small steps in double precision,
// alone and inside the whole stage.
#include "game/sim/contact/sweep.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "gpu/math/exact_math.h"
#include "tests/game/sim/random_values.h"
#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"
#include "tests/reference/sim_gap.h"

namespace gw::test {
namespace {

constexpr double kLook_m = 0.002;    // the oracle's step: it can miss what is grazed for less
constexpr double kGrazing_m = 0.02;  // gaps this small are too close to call

// A way that passes the origin within a little more than the sizes: head-on, grazing or just missing.
struct Way {
  float x, y, dx, dy;
};
Way someWay(float reach, float length) {
  const float angle = number(-3.14159f, 3.14159f), aside = number(-1.3f, 1.3f) * reach,
              before = number(-0.2f, 1.0f) * length;
  const float c = cpu::cosine(angle), s = cpu::sine(angle);
  return {-c * before - s * aside, -s * before + c * aside, c * length, s * length};
}

RC_GTEST_PROP(sweep, meets_what_small_steps_meet, ()) {
  const EnemyRules body = someBody();
  const float radius = number(0.02f, 1.0f), reach = cpu::length(body.halfWidth_m, body.halfHeight_m) + radius;
  const Way way = someWay(reach, number(0.001f, 75.0f));  // to 100 times a shot's step
  const float t = cpu::sweepBody(way.x, way.y, way.dx, way.dy, radius, body);
  const naive::ClosestGap seen = naive::closestGap(way.x, way.y, way.dx, way.dy, radius, body, kLook_m);
  if (seen.gap > kGrazing_m) RC_ASSERT(t > 1.0f);
  if (seen.gap < -kGrazing_m) {
    RC_ASSERT(t >= 0.0f);
    RC_ASSERT(t <= 1.0f);
    const double there =
        naive::gapAt(double(way.x) + double(way.dx) * t, double(way.y) + double(way.dy) * t, radius, body);
    RC_ASSERT(t == 0.0f || std::fabs(there) < 0.01);  // it stops at the skin
    RC_ASSERT(t <= seen.time + 1.0e-4);               // the near one
  }
}

RC_GTEST_PROP(sweep, is_the_naive_formula_to_the_last_bit, ()) {
  const EnemyRules body = someBody();
  const float radius = number(0.02f, 1.0f);
  const Way way = someWay(3.0f, number(0.0f, 20.0f));
  RC_ASSERT(cpu::sweepBody(way.x, way.y, way.dx, way.dy, radius, body) ==
            naive::meeting(way.x, way.y, way.dx, way.dy, radius, body));
}

TEST(sweep, corners_are_round) {
  EnemyRules box{};
  box.bounds = Bounds::rectangle;
  box.halfWidth_m = box.halfHeight_m = 1.0f;
  // Past the corner at a distance of 0.21 along the diagonal, though within the box grown by 0.2 both ways.
  const float past = 1.0f + 0.21f * 0.70710678f;
  EXPECT_GT(cpu::sweepBody(past - 5.0f, past + 5.0f, 10.0f, -10.0f, 0.2f, box), 1.0f);
  EXPECT_LE(cpu::sweepBody(past - 5.0f, past + 5.0f, 10.0f, -10.0f, 0.22f, box), 1.0f);
}

TEST(sweep, touching_at_the_start_is_a_meeting_at_zero) {
  EnemyRules ball{};
  ball.halfWidth_m = ball.halfHeight_m = 1.0f;
  EXPECT_EQ(cpu::sweepBody(0.5f, 0.0f, 9.0f, 0.0f, 0.2f, ball), 0.0f);  // even on the way out
  EXPECT_EQ(cpu::sweepBody(0.0f, 0.0f, 0.0f, 0.0f, 0.2f, ball), 0.0f);  // even at rest
  EXPECT_GT(cpu::sweepBody(1.3f, 0.0f, 9.0f, 0.0f, 0.2f, ball), 1.0f);
  EXPECT_GT(cpu::sweepBody(1.3f, 0.0f, 0.0f, 0.0f, 0.2f, ball), 1.0f);
}

// The whole stage: gathers with their radii, moving targets, all speeds.
RC_GTEST_PROP(sweep, no_shot_passes_an_enemy_in_the_game, ()) {
  SimulationConfig config = stageConfig(8);
  Rules& rules = config.rules;
  rules.enemies[0] = someBody();
  rules.enemies[0].energy = 1000.0f;
  rules.enemies[0].mass = 1.0f;
  rules.shot.radius_m = number(0.02f, 1.0f);
  rules.shot.speed_mps = 45.0f * number(0.1f, 10.0f) * number(0.1f, 10.0f);
  const float reach = cpu::length(rules.enemies[0].halfWidth_m, rules.enemies[0].halfHeight_m) + rules.shot.radius_m;
  const Way way = someWay(reach, rules.shot.speed_mps * kTick_s);
  const float x = number(3.0f, 189.0f), y = number(3.0f, 105.0f);

  StageFixture fixture(config);
  naive::World world = fixture.emptyWorld();
  world.globals.tick = kLateTick;
  EntityRecord e = enemyAt(rules, 3, 0, x, y);
  e.velocity_x = number(-24.0f, 24.0f);
  e.velocity_y = number(-24.0f, 24.0f);
  EntityRecord shot = shotAt(rules, 7, x + way.x, y + way.y, 0.0f);
  shot.direction_x = way.dx / (rules.shot.speed_mps * kTick_s);
  shot.direction_y = way.dy / (rules.shot.speed_mps * kTick_s);
  shot.velocity_x = shot.direction_x * rules.shot.speed_mps;
  shot.velocity_y = shot.direction_y * rules.shot.speed_mps;
  RC_PRE(shot.x >= 0.0f && shot.x <= 192.0f && shot.y >= 0.0f && shot.y <= 108.0f);
  world.add(e);
  world.add(shot);
  fixture.begin(world);
  cpu::integrate(fixture.queue(), fixture.view());
  const EntityRecord moved = fixture.entities(true, true).at(0);
  cpu::collide(fixture.queue(), fixture.view());

  const naive::ClosestGap seen = naive::closestGap(
      double(shot.x) - double(e.x), double(shot.y) - double(e.y), double(way.dx) - (double(moved.x) - double(e.x)),
      double(way.dy) - (double(moved.y) - double(e.y)), rules.shot.radius_m, rules.enemies[0], kLook_m);
  const EntityRecord after = fixture.entities(true, true).at(0);
  if (seen.gap < -kGrazing_m) RC_ASSERT(after.energy == 999.0f);
  if (seen.gap > kGrazing_m) RC_ASSERT(after.energy == 1000.0f);
}

}  // namespace
}  // namespace gw::test
