#include "game/tables/game_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "game/tables/toml_reader.h"

namespace gw {
namespace {

constexpr uint32_t kLongest_ticks = 3600;  // one minute, for anything counted in ticks

void readWorld(TomlTable table, Rules::World& world) {
  world.width_m = table.number("width_m", 64, 1000);
  world.height_m = table.number("height_m", 64, 1000);
  world.spawnClearance_m = table.number("spawn_clearance_m", 0, 30);
  world.announced_ticks = table.integer32("announced_ticks", 0, kLongest_ticks);
  table.done();
}

void readShip(TomlTable table, Rules::Ship& ship) {
  ship.radius_m = table.number("radius_m", 0.05, 5);
  ship.speed_mps = table.number("speed_mps", 0.1, 60);
  ship.response = table.number("response", 0.01, 1);
  ship.untouchable_ticks = table.integer32("untouchable_ticks", 1, kLongest_ticks);
  ship.blast_m = table.number("blast_m", 0, 50);
  ship.weakEnergy = table.number("weak_energy", 0, 1000);
  table.done();
}

void readBudget(TomlTable table, Rules::Budget& budget) {
  budget.start_us = table.integer32("start_us", 1, 1'000'000);
  budget.limit_us = table.integer32("limit_us", 1, 1'000'000);
  if (budget.limit_us <= budget.start_us) {
    table.refuse("limit_us", fmt::format("{} is not above start_us ({}); raise it", budget.limit_us, budget.start_us));
  }
  budget.bitReturns_us = table.integer32("bit_returns_us", 0, 100'000);
  budget.bankFill_us = table.integer32("bank_fill_us", 0, 100'000);
  budget.bankMax_us = table.integer32("bank_max_us", 0, 1'000'000);
  budget.hitStop_ms = table.integer32("hit_stop_ms", 0, 1000);
  table.done();
}

ShotLevel readShotLevel(TomlTable& table, const Rules::Shot& shot) {
  ShotLevel level{};
  level.fromTenths = table.integer32("from_tenths", 10, 1'000'000);
  if (shot.levelCount == 0 && level.fromTenths != 10) {
    table.refuse("from_tenths", fmt::format("the first level starts at {}; write 10, the multiplier x1.0 that a run "
                                            "begins with",
                                            level.fromTenths));
  }
  if (shot.levelCount && level.fromTenths <= shot.levels[shot.levelCount - 1].fromTenths) {
    table.refuse("from_tenths",
                 fmt::format("{} is not above the level before; order levels upwards", level.fromTenths));
  }
  level.count = table.integer32("count", 1, 16);
  level.spread_rad = table.number("spread_rad", 0, 0.5);
  level.every_ticks = table.integer32("every_ticks", 1, 60);
  level.hits = table.integer32("hits", 1, 3);  // a shot remembers its last two victims, and hits none twice
  table.done();
  return level;
}

void readShot(TomlTable table, Rules::Shot& shot) {
  shot.speed_mps = table.number("speed_mps", 1, 200);
  shot.radius_m = table.number("radius_m", 0.01, 2);
  shot.damage = table.number("damage", 0.01, 1000);
  shot.life_ticks = table.integer32("life_ticks", 1, 600);
  shot.knockBack_mps = table.number("knock_back_mps", 0, 50);
  for (TomlTable& level : table.tables("level", kMaxShotLevels)) {
    shot.levels[shot.levelCount] = readShotLevel(level, shot);
    ++shot.levelCount;
  }
  table.done();
}

void readBit(TomlTable table, Rules::Bit& bit) {
  bit.life_ticks = table.integer32("life_ticks", 1, kLongest_ticks);
  bit.speed_mps = table.number("speed_mps", 0.1, 100);
  bit.attract_m = table.number("attract_m", 0.1, 50);
  bit.take_m = table.number("take_m", 0.1, 50);
  if (bit.take_m > bit.attract_m) {
    table.refuse("take_m", fmt::format("{} is beyond attract_m ({}); lower it", bit.take_m, bit.attract_m));
  }
  bit.multiplierTenths = table.integer32("multiplier_tenths", 0, 100);
  table.done();
}

void readFlush(TomlTable table, Rules::Flush& flush) {
  flush.start = table.integer32("start", 0, 100);
  flush.most = table.integer32("most", 0, 100);
  if (flush.most < flush.start) {
    table.refuse("most", fmt::format("{} is below start ({}); raise it", flush.most, flush.start));
  }
  flush.speed_mps = table.number("speed_mps", 1, 500);
  flush.reach_m = table.number("reach_m", 1, 200);
  flush.untouchable_ticks = table.integer32("untouchable_ticks", 0, kLongest_ticks);
  for (uint64_t score : table.ascendingIntegers("scores", kMaxFlushScores, 1, 1'000'000'000'000'000)) {
    flush.scores[flush.scoreCount++] = score;
  }
  table.done();
}

void readSteering(TomlTable table, Rules::Steering& steering) {
  steering.response = table.number("response", 0.001, 1);
  steering.wanderSpeed = table.number("wander_speed", 0, 2);
  steering.wanderDrift_rad = table.number("wander_drift_rad", 0, 3);
  steering.wanderToShip = table.number("wander_to_ship", 0, 10);
  steering.damagedSpeed = table.number("damaged_speed", 0.1, 4);
  steering.separation_mps = table.number("separation_mps", 0, 60);
  steering.press_mps = table.number("press_mps", 0.01, 1.0e6);
  steering.sightLost = table.number("sight_lost", 1, 10);
  steering.cohesion = table.number("cohesion", 0, 10);
  steering.alignment = table.number("alignment", 0, 10);
  steering.attackAlignment = table.number("attack_alignment", 0, 10);
  steering.sideways = table.number("sideways", 0, 10);
  steering.sidewaysBeyond_m = table.number("sideways_beyond_m", 0, 1000);
  steering.threat_m = table.number("threat_m", 0, 20);
  steering.threatMargin_m = table.number("threat_margin_m", 0, 5);
  steering.avoid_mps = table.number("avoid_mps", 0, 18);  // as enemies' speed_mps
  steering.avoidResponse = table.number("avoid_response", 0.001, 1);
  steering.avoid_ticks = table.integer32("avoid_ticks", 1, kLongest_ticks);
  steering.escapeBelow = table.number("escape_below", 0, 1);
  steering.recoveredAt = table.number("recovered_at", 0, 1);
  if (steering.recoveredAt <= steering.escapeBelow) {
    table.refuse("recovered_at", fmt::format("{} is not above escape_below ({}); raise it", steering.recoveredAt,
                                             steering.escapeBelow));
  }
  steering.recover_per_s = table.number("recover_per_s", 0.01, 1000);
  steering.escapeSpeed = table.number("escape_speed", 0, 2);
  steering.escapeWall_m = table.number("escape_wall_m", 0, 100);
  table.done();
}

void readEndless(TomlTable table, Rules& rules) {
  Rules::Endless& endless = rules.endless;
  endless.from_ticks = table.integer32("from_s", 1, 3600) * kTicksPerSecond;
  const Wave& last = rules.waves[rules.waveCount - 1];
  if (endless.from_ticks <= last.at_ticks) {
    table.refuse("from_s", fmt::format("{} s does not come after the last wave ({} s); start later",
                                       endless.from_ticks / kTicksPerSecond, last.at_ticks / kTicksPerSecond));
  }
  endless.every_ticks = table.integer32("every_s", 1, 3600) * kTicksPerSecond;
  endless.points = table.number("points", 1, 1'000'000);
  endless.growth = table.number("growth", 1, 2);
  endless.paceGrowth = table.number("pace_growth", 1, 2);
  endless.paceMost = table.number("pace_most", 1, 4);

  TomlTable prices = table.table("price");
  TomlTable chances = table.table("chance_percent");
  uint32_t sum_percent = 0;
  for (uint32_t i = 0; i < rules.enemyTypeCount; ++i) {
    endless.price[i] = prices.number(rules.enemies[i].name, 0.1, 1'000);
    endless.chance_percent[i] = chances.integer32(rules.enemies[i].name, 0, 100);
    sum_percent += endless.chance_percent[i];
  }
  prices.done();
  chances.done();
  if (sum_percent != 100) {
    table.refuse("chance_percent", fmt::format("the chances add up to {}; make them 100", sum_percent));
  }
  table.done();
}

void readIdle(TomlTable table, Rules::Idle& idle) {
  idle.fewerThan = table.integer32("fewer_than", 0, 10'000);
  idle.halfWidth_m = table.number("half_width_m", 1, 500);
  idle.halfHeight_m = table.number("half_height_m", 1, 500);
  idle.wait_ticks = table.integer32("wait_ticks", 1, kLongest_ticks);
  idle.pays = table.integer32("pays", 0, 100'000);
  table.done();
}

void readDeadline(TomlTable table, Rules::Deadline& deadline) {
  deadline.clock_ticks = table.integer32("clock_s", 1, 3600) * kTicksPerSecond;
  deadline.waveRate = table.integer32("wave_rate", 1, 10);
  deadline.contactTicks_per_ms = table.integer32("contact_ticks_per_ms", 0, 1000);
  table.done();
}

void readSwarm(TomlTable table, Rules::Swarm& swarm) {
  swarm.clearance_m = table.number("clearance_m", 0, 30);
  swarm.multiplierTenths = table.integer32("multiplier_tenths", 10, 1'000'000);
  swarm.attackShare = table.number("attack_share", 0, 1);
  table.done();
}

}  // namespace

void readGameTable(const RuleText& text, Rules& rules) {
  TomlTable document = TomlTable::parse(text);
  readWorld(document.table("world"), rules.world);
  readShip(document.table("ship"), rules.ship);
  readBudget(document.table("budget"), rules.budget);
  readShot(document.table("shot"), rules.shot);
  readBit(document.table("bit"), rules.bit);
  readFlush(document.table("flush"), rules.flush);
  readSteering(document.table("steering"), rules.steering);
  readEndless(document.table("endless"), rules);
  readIdle(document.table("idle"), rules.idle);
  readDeadline(document.table("deadline"), rules.deadline);
  readSwarm(document.table("swarm"), rules.swarm);
  document.done();
}

}  // namespace gw
