// The whole game beside its naive version, record by record and byte by byte of the globals, tick after tick.
#include <gtest/gtest.h>

#include "tests/game/sim/game_runs.h"

namespace gw::test {
namespace {

// Plays `ticks` ticks with the simulation's own bot and replays its inputs in the naive game.
void playBoth(SimulationConfig config, const naive::World& start, uint32_t ticks) {
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(snapshotOf(start));
  naive::World world = start;
  for (uint32_t t = 0; t < ticks && !world.globals.over; ++t) {
    simulation->tick({});
    naive::tick(world, simulation->report().input);
    const Snapshot is = simulation->snapshot();
    ASSERT_TRUE(same(globalsOf(is), world.globals)) << "tick " << world.globals.tick;
    ASSERT_TRUE(same(is.entities, world.records())) << "tick " << world.globals.tick;
  }
}

TEST(game_naive, the_first_waves_are_the_same) {
  SimulationConfig config = stageConfig();
  config.autopilot = Autopilot::novice;
  playBoth(config, StageFixture(config).emptyWorld(), 900);
}

TEST(game_naive, a_crowd_against_wide_salvoes_is_the_same) {
  SimulationConfig config = stageConfig();
  config.autopilot = Autopilot::expert;
  naive::World world = StageFixture(config).emptyWorld();
  world.globals.tick = world.globals.waveClock_ticks = kLateTick;
  world.globals.wave = 5;
  world.globals.multiplierTenths = 1200;
  Dice dice(7);
  addCrowd(world, 200, 60, 40, 20.0f, dice);
  playBoth(config, world, 240);
}

TEST(game_naive, the_last_seconds_are_the_same) {
  SimulationConfig config = stageConfig();
  config.autopilot = Autopilot::novice;
  naive::World world = StageFixture(config).emptyWorld();
  world.globals.tick = world.globals.waveClock_ticks = 12000;
  world.globals.wave = config.rules.waveCount;
  world.globals.endless = 2;
  world.globals.frameTime_us = 70000;
  world.globals.score = 99990;
  world.globals.ship.x = 3.0f;
  world.globals.ship.y = 4.0f;
  Dice dice(8);
  addCrowd(world, 120, 20, 90, 12.0f, dice);
  playBoth(config, world, 600);
}

TEST(game_naive, the_deadline_is_the_same) {
  SimulationConfig config = stageConfig();
  config.mode = Mode::deadline;
  config.autopilot = Autopilot::novice;
  naive::World world = StageFixture(config).emptyWorld();
  world.globals.tick = world.globals.waveClock_ticks = 6000;
  world.globals.wave = 10;
  world.globals.clock_ticks = 500;
  Dice dice(9);
  addCrowd(world, 120, 20, 90, 12.0f, dice);
  playBoth(config, world, 520);
}

TEST(game_naive, a_swarm_is_the_same) {
  SimulationConfig config = stageConfig();
  config.mode = Mode::swarm;
  config.autopilot = Autopilot::expert;
  playBoth(config, StageFixture(config).emptyWorld(), 400);
}

TEST(game_naive, practice_is_the_same) {
  SimulationConfig config = stageConfig();
  config.mode = Mode::practice;
  config.autopilot = Autopilot::expert;  // asks for company itself
  playBoth(config, StageFixture(config).emptyWorld(), 900);
}

TEST(game_naive, endless_waves_that_do_not_fit_are_the_same) {
  SimulationConfig config = stageConfig(128);
  config.autopilot = Autopilot::expert;
  naive::World world = StageFixture(config).emptyWorld();
  world.globals.wave = config.rules.waveCount;
  world.globals.endless = 3;
  world.globals.tick = 10000;
  world.globals.waveClock_ticks = config.rules.endless.from_ticks + 3 * config.rules.endless.every_ticks - 10;
  playBoth(config, world, 300);
}

}  // namespace
}  // namespace gw::test
