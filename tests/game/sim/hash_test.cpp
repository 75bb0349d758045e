// The hash sees every simulated bit, and nothing else; the report says what the globals and settle say.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <numeric>
#include <set>

#include "tests/game/sim/scenes.h"
#include "tests/game/sim/stage_fixture.h"

namespace gw::test {
namespace {

class hash : public ::testing::Test {
 protected:
  StageFixture fixture;
  naive::World world = fixture.emptyWorld();
  const Rules& rules = fixture.rules();

  hash() { world.globals.tick = kLateTick; }

  TickReport run(const naive::World& of) { return run(fixture, of); }
  static TickReport run(StageFixture& on, const naive::World& of) {
    on.begin(of);
    // As integrate would leave those who do not move.
    on.state().cells[1].upload(on.state().cells[0].download());
    cpu::hash(on.queue(), on.view());
    cpu::report(on.queue(), on.view());
    return on.state().report.download()[0];
  }
};

TEST_F(hash, every_bit_of_every_field_of_an_entity_changes_it) {
  world.add(enemyAt(rules, 5, 1, 40.0f, 50.0f));
  world.add(shotAt(rules, 9, 60.0f, 50.0f, 0.3f, 2));
  std::set<uint64_t> hashes{run(world).hash};
  size_t changes = 0;
  for (size_t i = 0; i < world.entities.size(); ++i) {
    // Past id and type: those are tested below. Only places that are numbers live.
    for (size_t offset = 8; offset < sizeof(EntityRecord); offset += 4) {
      const bool isState = i == 0 && offset == offsetof(EntityRecord, state);  // of those there are only four
      for (const uint32_t bit : isState ? std::vector<uint32_t>{0, 1} : std::vector<uint32_t>{0, 13, 22, 31}) {
        naive::World other = world;
        EntityRecord& e = other.entities[i];
        uint32_t word;
        std::memcpy(&word, reinterpret_cast<char*>(&e) + offset, 4);
        word ^= 1u << bit;
        std::memcpy(reinterpret_cast<char*>(&e) + offset, &word, 4);
        hashes.insert(run(other).hash);
        ++changes;
      }
    }
  }
  EXPECT_EQ(hashes.size(), changes + 1);
}

TEST_F(hash, every_word_of_the_globals_changes_it) {
  std::set<uint64_t> hashes{run(world).hash};
  for (size_t offset = 0; offset < sizeof(GameGlobals); offset += 4) {
    naive::World other = world;
    uint32_t word;
    std::memcpy(&word, reinterpret_cast<char*>(&other.globals) + offset, 4);
    word ^= 1u;
    std::memcpy(reinterpret_cast<char*>(&other.globals) + offset, &word, 4);
    hashes.insert(run(other).hash);
  }
  EXPECT_EQ(hashes.size(), sizeof(GameGlobals) / 4 + 1);
}

TEST_F(hash, type_id_and_presence_change_it) {
  std::set<uint64_t> hashes{run(world).hash};
  EntityRecord e = enemyAt(rules, 5, 1, 40.0f, 50.0f);
  for (const uint32_t id : {5u, 6u}) {
    for (const uint32_t type : {0u, 1u, 2u, uint32_t(kTypeBit)}) {
      e.id = id;
      e.type = type;
      world.entities.clear();
      world.add(e);
      hashes.insert(run(world).hash);
    }
  }
  EXPECT_EQ(hashes.size(), 9u);
}

TEST_F(hash, two_who_change_places_are_not_the_same) {
  world.add(enemyAt(rules, 1, 0, 40.0f, 50.0f));
  world.add(enemyAt(rules, 2, 0, 41.0f, 50.0f));
  const uint64_t before = run(world).hash;
  std::swap(world.entities[0].x, world.entities[1].x);
  EXPECT_NE(run(world).hash, before);
}

TEST_F(hash, neither_the_arrangement_nor_the_order_of_visits_is_felt) {
  Dice dice(3);
  addCrowd(world, 200, 80, 80, 50.0f, dice);
  const uint64_t wanted = run(world).hash;
  for (const VisitOrder order : {VisitOrder::reversed, VisitOrder::shuffled}) {
    for (const uint32_t threads : {1u, 3u}) {
      SimulationConfig config = stageConfig();
      config.order = order;
      config.threads = threads;
      StageFixture other(config);
      EXPECT_EQ(run(other, world).hash, wanted);
    }
  }
  // The same entities in cells by id, as no sort would leave them.
  auto cells = fixture.state().cells[1].download();
  std::vector<Cell> byId(cells.size());
  for (const Cell& cell : cells) byId[cell.id] = cell;
  fixture.state().cells[1].upload(byId);
  std::vector<uint32_t> own(cells.size());
  std::iota(own.begin(), own.end(), 0u);
  fixture.state().cellOf.upload(own);
  cpu::hash(fixture.queue(), fixture.view());
  cpu::report(fixture.queue(), fixture.view());
  const TickReport report = fixture.state().report.download()[0];
  EXPECT_EQ(report.hash, wanted);
}

TEST_F(hash, the_report_repeats_the_globals_and_the_totals) {
  GameGlobals& m = world.globals;
  m.score = 0x123456789Aull;
  m.kills = 77;
  m.killsByType[2] = 7;
  m.multiplierTenths = 345;
  m.frameTime_us = 40000;
  m.bank_us = 300;
  m.flushes = 2;
  m.flush_x = 5.0f;
  m.flushRadius_m = 9.0f;
  m.ship.untouchable_ticks = 44;
  m.ship.aim_rad = 1.5f;
  m.wave = 19;
  m.endless = 4;
  m.pace = 1.25f;
  m.refused = 6;
  m.bitsTaken = 8;
  m.contacts = 3;
  m.peakEnemies = 10;
  m.totals.occupied[0] = 30;
  m.totals.occupied[2] = 3;
  m.totals.dying = 4;
  m.totals.occupied[kTypeShot] = 11;
  m.totals.occupied[kTypeBit] = 12;
  m.totals.inView = 21;
  m.idle_ticks = 17;
  m.totals.bitsTaken = 70000;  // more than a count of sounds holds
  const TickReport r = run(world);
  EXPECT_EQ(r.tick, kLateTick);
  EXPECT_EQ(r.score, m.score);
  EXPECT_EQ(r.kills, 77u);
  EXPECT_EQ(r.killsByType[2], 7u);
  EXPECT_EQ(r.multiplierTenths, 345u);
  EXPECT_EQ(r.frameTime_us, 40000u);
  EXPECT_EQ(r.bank_us, 300u);
  EXPECT_EQ(r.flushes, 2u);
  EXPECT_EQ(r.flush_x, 5.0f);
  EXPECT_EQ(r.flushRadius_m, 9.0f);
  EXPECT_EQ(r.untouchable_ticks, 44u);
  EXPECT_EQ(r.aim_rad, 1.5f);
  EXPECT_EQ(r.wave, 23u);
  EXPECT_EQ(r.pace, 1.25f);
  EXPECT_EQ(r.enemies, 29u);
  EXPECT_EQ(r.shots, 11u);
  EXPECT_EQ(r.bits, 12u);
  EXPECT_EQ(r.enemiesInView, 21u);
  EXPECT_EQ(r.idle_ticks, 17u);
  EXPECT_EQ(r.peakEnemies, 29u);
  EXPECT_EQ(r.refused, 6u);
  EXPECT_EQ(r.bitsTaken, 8u);
  EXPECT_EQ(r.contacts, 3u);
  EXPECT_EQ(r.contactType, uint32_t(kTypeNone));
  EXPECT_EQ(r.sounds[uint32_t(SoundEvent::bit)][1], 65535u);
  EXPECT_EQ(r.ship_x, m.ship.x);
}

}  // namespace
}  // namespace gw::test
