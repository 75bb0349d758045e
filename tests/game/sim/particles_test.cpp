// Particles: what is thrown, the ring, and that the game does not feel them.
#include "game/sim/draw/particles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "game/sim/draw/particle_list.h"
#include "tests/game/sim/game_runs.h"
#include "tests/reference/sim_particles.h"

namespace gw::test {
namespace {

::testing::AssertionResult same(const std::vector<Particle>& is, const std::vector<Particle>& wanted) {
  if (is.size() != wanted.size()) {
    return ::testing::AssertionFailure() << is.size() << " particles, not " << wanted.size();
  }
  for (size_t i = 0; i < is.size(); ++i) {
    if (std::memcmp(&is[i], &wanted[i], sizeof(Particle)) == 0) continue;
    return ::testing::AssertionFailure() << "particle " << i << " at (" << is[i].x << ", " << is[i].y << ") of "
                                         << std::hex << is[i].colour << ", not at (" << wanted[i].x << ", "
                                         << wanted[i].y << ") of " << wanted[i].colour;
  }
  return ::testing::AssertionSuccess();
}

class particles : public ::testing::Test {
 protected:
  static constexpr uint32_t kSize = 4096;

  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();
  cpu::Particles ring{fixture.queue(), fixture.limits().capacity, kSize};

  particles() { world.globals.tick = kLateTick; }

  // A tick without its logic and spawn, and what it throws.
  std::vector<Particle> run(cpu::Particles& into, uint32_t parity = 0) {
    fixture.begin(world);
    stages();
    into.emit(fixture.queue(), fixture.view(), parity);
    return into.list(parity + 1);
  }
  void stages() {
    cpu::think(fixture.queue(), fixture.view());
    cpu::integrate(fixture.queue(), fixture.view());
    cpu::collide(fixture.queue(), fixture.view());
    cpu::settle(fixture.queue(), fixture.view());
  }

  // What a tick left on the device that throws particles, found by plain loops.
  std::vector<naive::Happened> happened() {
    const auto events = fixture.events();
    const auto state = fixture.state().state.download();
    const auto before = fixture.state().cells[0].download(), after = fixture.state().cells[1].download();
    const auto cellOf = fixture.state().cellOf.download(), spent = fixture.state().spent.download();
    const auto motion = fixture.state().velocityPrevious.download();
    const auto time = fixture.state().choiceTime.download();
    std::vector<naive::Happened> found;
    for (uint32_t id = 0; id < fixture.limits().capacity; ++id) {
      const Cell& cell = before[cellOf[id]];
      if (cell.type < kMaxEnemyTypes && (events[id] & kEventDied) && state[id].x == uint32_t(State::dead)) {
        const Cell& end = after[cellOf[id]];
        found.push_back({naive::Happened::death, id, end.x, end.y, 0, 0, cell.type});
      } else if (cell.type == kTypeShot && spent[id] != 0) {
        const float until_s = time[id] * kTick_s;
        found.push_back({naive::Happened::hit, id, cell.x + motion[id].x * until_s, cell.y + motion[id].y * until_s,
                         motion[id].x, motion[id].y, kTypeShot});
      } else if (cell.type == kTypeBit && (events[id] & kEventTaken)) {
        found.push_back({naive::Happened::taken, id, cell.x, cell.y, 0, 0, kTypeBit});
      }
    }
    return found;
  }

  EntityRecord& dyingAt(uint32_t id, uint32_t type, float x, float y) {
    EntityRecord& enemy = world.add(enemyAt(rules, id, type, x, y));
    enemy.energy = 0;
    enemy.state = uint32_t(State::checkingEnergy);
    return enemy;
  }
};

TEST_F(particles, are_those_of_the_naive_version_on_crowds) {
  uint32_t deaths = 0, hits = 0, taken = 0;
  for (uint32_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    world = fixture.emptyWorld();
    world.globals.seed = seed * 0x123456789ull;
    world.globals.tick = kLateTick + seed;
    world.globals.ship.velocity_x = float(seed % 3) * 4.0f;
    Dice dice(seed);
    addCrowd(world, 200, 60, 120, seed % 2 ? 20.0f : 8.0f, dice);
    for (naive::Entity& e : world.entities) {
      if (!world.isEnemy(e) || e.id % 7 != 0 || e.state == uint32_t(State::dead)) continue;
      e.energy = 0;  // shot in the tick before, about to find out
      e.state = uint32_t(State::checkingEnergy);
    }
    fixture.begin(world);
    TickScratch scratch = fixture.scratch();
    scratch.contactSounds = seed % 5 == 1;
    scratch.flushSounds = seed % 5 == 2;
    fixture.setScratch(scratch);
    stages();
    cpu::Particles fresh(fixture.queue(), fixture.limits().capacity, kSize);
    fresh.emit(fixture.queue(), fixture.view(), 0);
    const auto events = happened();
    EXPECT_TRUE(same(fresh.list(1), naive::thrown(world, events, scratch)));
    for (const naive::Happened& h : events) ++(h.what == h.death ? deaths : h.what == h.hit ? hits : taken);
  }
  EXPECT_GT(deaths, 50u);
  EXPECT_GT(hits, 50u);
  EXPECT_GT(taken, 5u);
}

TEST_F(particles, fly_from_where_an_enemy_dies_as_many_as_its_type_throws) {
  const uint32_t wanted[] = {12, 16, 40, 11, 13, 18, 27};  // docs/design/effects.md
  for (uint32_t type = 0; type < rules.enemyTypeCount; ++type) {
    SCOPED_TRACE(rules.enemies[type].name);
    world.entities.clear();
    dyingAt(7, type, 40.0f, 41.0f);
    cpu::Particles fresh(fixture.queue(), fixture.limits().capacity, kSize);
    const auto list = run(fresh);
    ASSERT_EQ(list.size(), wanted[type]);
    for (const Particle& p : list) {
      EXPECT_EQ(p.x, 40.0f);
      EXPECT_EQ(p.y, 41.0f);
      EXPECT_EQ(p.birthTick, kLateTick);
      EXPECT_EQ(p.colour, rules.enemies[type].colour);
      EXPECT_GT(std::hypot(p.velocity_x, p.velocity_y), 3.9f);
    }
  }
}

TEST_F(particles, come_once_for_one_death) {
  dyingAt(7, 0, 40.0f, 41.0f);
  run(ring);
  EntityRecord& dead = world.entities.front();
  dead.state = uint32_t(State::dead);  // as it lies there in the tick in which spawn frees its id
  EXPECT_EQ(run(ring, 1).size(), 12u);
}

TEST_F(particles, drop_the_oldest_when_the_ring_is_full) {
  cpu::Particles small(fixture.queue(), fixture.limits().capacity, 64);
  std::vector<Particle> all;
  for (uint32_t t = 0; t < 9; ++t) {
    world.entities.clear();
    world.globals.tick = kLateTick + t;
    dyingAt(t, t % 2, 30.0f + float(t), 40.0f);
    const auto list = run(small, t);
    const auto fresh = naive::thrown(world, happened(), TickScratch{});
    all.insert(all.end(), fresh.begin(), fresh.end());
    ASSERT_TRUE(same(list, {all.end() - std::min<ptrdiff_t>(64, ptrdiff_t(all.size())), all.end()})) << t;
  }
  EXPECT_GT(all.size(), 100u);
}

TEST_F(particles, keep_the_last_ones_when_a_tick_throws_more_than_fit) {
  cpu::Particles small(fixture.queue(), fixture.limits().capacity, 64);
  for (uint32_t id = 0; id < 5; ++id) dyingAt(id, 2, 30.0f + 5.0f * float(id), 40.0f);
  const auto list = run(small);
  const auto all = naive::thrown(world, happened(), TickScratch{});
  ASSERT_EQ(all.size(), 200u);
  EXPECT_TRUE(same(list, {all.end() - 64, all.end()}));
}

TEST_F(particles, of_a_lost_ship_are_the_last) {
  dyingAt(7, 0, 40.0f, 41.0f);
  fixture.begin(world);
  stages();
  GameGlobals over = fixture.globals();
  over.over = uint32_t(Ending::frameRate);
  fixture.setGlobals(over);
  TickScratch scratch = fixture.scratch();
  scratch.overSounds = 1;
  fixture.setScratch(scratch);
  ring.emit(fixture.queue(), fixture.view(), 0);
  const auto last = ring.list(1);
  ASSERT_EQ(last.size(), 320u);  // what events still say is of the tick before
  EXPECT_EQ(last.front().x, over.ship.x);
  scratch.overSounds = 0;
  fixture.setScratch(scratch);
  for (uint32_t parity : {1u, 0u, 1u}) {
    ring.emit(fixture.queue(), fixture.view(), parity);
    EXPECT_TRUE(same(ring.list(parity + 1), last));
  }
}

TEST_F(particles, are_gone_when_the_ring_is_cleared) {
  dyingAt(7, 0, 40.0f, 41.0f);
  EXPECT_EQ(run(ring).size(), 12u);
  ring.clear();
  EXPECT_TRUE(ring.list(0).empty());
  EXPECT_EQ(run(ring, 1).size(), 12u);
}

class particle_list : public particles {
 protected:
  cpu::ParticleList list{fixture.queue(), kSize};
  const DrawView everything{96.0f, 54.0f, 96.0f, 54.0f};
  DrawArraysCommand command{};

  std::vector<ParticleVertex> draw(float sinceTick_ticks, const DrawView& window, uint32_t capacity = kSize) {
    std::vector<ParticleVertex> vertices(capacity);
    list.run(fixture.queue(), fixture.view(), ring.view(1), window, sinceTick_ticks,
             {vertices.data(), capacity, &command});
    EXPECT_EQ(command.vertexCount, 3u);
    EXPECT_EQ(command.firstVertex, 0u);
    EXPECT_EQ(command.baseInstance, 0u);
    EXPECT_LE(command.instanceCount, capacity);
    vertices.resize(std::min(command.instanceCount, capacity));
    return vertices;
  }
};

TEST_F(particle_list, shows_where_drag_has_left_them_the_newest_first) {
  dyingAt(7, 0, 40.0f, 41.0f);
  dyingAt(9, 1, 60.0f, 41.0f);
  const auto thrown = run(ring);
  for (const float since : {0.0f, 0.5f, 1.0f, 12.25f}) {
    SCOPED_TRACE(since);
    const auto drawn = draw(since, everything);
    ASSERT_EQ(drawn.size(), thrown.size());
    for (size_t i = 0; i < drawn.size(); ++i) {
      const Particle& p = thrown[thrown.size() - 1 - i];
      const auto way = [](double age_s) { return (1 - std::exp(-5 * age_s)) / 5; };
      const double age_s = since / 60, tail_s = std::max(0.0, age_s - 0.1);
      EXPECT_NEAR(drawn[i].x, p.x + p.velocity_x * way(age_s), 1e-4);
      EXPECT_NEAR(drawn[i].y, p.y + p.velocity_y * way(age_s), 1e-4);
      EXPECT_NEAR(drawn[i].tail_x, p.x + p.velocity_x * way(tail_s), 1e-4);
      EXPECT_EQ(drawn[i].colour, p.colour);
      EXPECT_EQ(drawn[i].size_m, p.size_m);
      EXPECT_GT(drawn[i].light, 0.0f);
      EXPECT_LE(drawn[i].light, 1.0f);
    }
  }
}

TEST_F(particle_list, leaves_out_the_dead_and_what_is_out_of_view) {
  dyingAt(7, 2, 40.0f, 41.0f);
  dyingAt(9, 2, 150.0f, 41.0f);
  const auto thrown = run(ring);
  ASSERT_EQ(draw(1, everything).size(), 80u);
  EXPECT_EQ(draw(1, {40.0f, 41.0f, 10.0f, 10.0f}).size(), 40u);
  for (const float since : {20.0f, 30.5f, 41.9f}) {
    size_t living = 0;
    for (const Particle& p : thrown) living += float(p.life_ticks) > since;
    EXPECT_EQ(draw(since, everything).size(), living) << since;
  }
  EXPECT_EQ(draw(42, everything).size(), 0u);
}

TEST_F(particle_list, leaves_out_the_oldest_when_the_target_is_small) {
  for (uint32_t id = 0; id < 6; ++id) dyingAt(id, 2, 30.0f + 10.0f * float(id), 40.0f);
  run(ring);
  const auto all = draw(1, everything);
  ASSERT_EQ(all.size(), 240u);
  for (const uint32_t capacity : {240u, 239u, 100u, 1u, 0u}) {
    const auto some = draw(1, everything, capacity);
    ASSERT_EQ(some.size(), capacity);
    const auto sameVertex = [](const ParticleVertex& a, const ParticleVertex& b) {
      return std::memcmp(&a, &b, sizeof a) == 0;
    };
    EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin(), sameVertex));
  }
}

// The whole game, with and without.
struct Seen {
  std::vector<uint64_t> hashes;
  std::vector<Particle> particles;
};

Seen playWith(bool on, uint32_t threads, VisitOrder order) {
  SimulationConfig config = stageConfig(1024);
  config.autopilot = Autopilot::expert;
  config.particles = on;
  config.threads = threads;
  config.order = order;
  const auto simulation = cpu::makeSimulation(config);
  simulation->restore(crowdScene(config, 500));
  const auto reports = play(*simulation, 240);
  return {hashesOf(reports), simulation->particles()};
}

TEST(particles_of_a_game, change_nothing_and_depend_on_nothing) {
  const Seen off = playWith(false, 1, VisitOrder::forward), on = playWith(true, 1, VisitOrder::forward);
  EXPECT_EQ(on.hashes, off.hashes);
  EXPECT_TRUE(off.particles.empty());
  EXPECT_GT(on.particles.size(), 500u);
  struct Way {
    uint32_t threads;
    VisitOrder order;
  };
  for (const Way way : {Way{2, VisitOrder::reversed}, Way{3, VisitOrder::shuffled}}) {
    const Seen other = playWith(true, way.threads, way.order);
    EXPECT_EQ(other.hashes, off.hashes);
    EXPECT_TRUE(same(other.particles, on.particles));
  }
}

TEST(particles_of_a_game, do_not_outlive_a_restart) {
  SimulationConfig config = stageConfig(1024);
  config.autopilot = Autopilot::expert;
  config.particles = true;
  const auto simulation = cpu::makeSimulation(config);
  const Snapshot start = crowdScene(config, 500);
  simulation->restore(start);
  play(*simulation, 121);  // an odd number: the other half of what alternates
  const auto first = simulation->particles();
  simulation->restore(start);
  EXPECT_TRUE(simulation->particles().empty());
  play(*simulation, 121);
  EXPECT_TRUE(same(simulation->particles(), first));
}

TEST(particles_of_a_game, are_left_out_of_a_simulation_made_without) {
  const auto simulation = cpu::makeSimulation(stageConfig());
  ParticleVertex vertex{};
  DrawArraysCommand command{3, 7, 0, 0};
  simulation->particleList({96.0f, 54.0f, 96.0f, 54.0f}, 1, {&vertex, 1, &command});
  EXPECT_EQ(command.instanceCount, 7u);  // untouched: the stream's region draws nothing by itself
}

}  // namespace
}  // namespace gw::test
