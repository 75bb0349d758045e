// Report: all that the host gets to see of a tick, with the hash of the globals added to that of the entities.
#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"
#include "gpu/math/state_hash.h"

namespace gw::GW_DEVICE {
namespace {

// One item in all.
struct Report {
  View v;

  GW_BODY void operator()(uint32_t) const {
    const GameGlobals& m = *v.globals;
    TickScratch& s = *v.scratch;
    TickReport& report = *v.report;  // in place: as a local it would not fit the registers of a thread
    report = TickReport{};
    report.tick = m.tick;
    report.over = m.over != 0;
    report.ending = Ending(m.over);
    for (uint32_t field = 0; field < kHashFields; ++field) {
      const uint64_t sum = s.fieldHashes[field] + (field == uint32_t(HashField::globals) ? globalsHash(m) : 0);
      report.fieldHashes[field] = sum;
      report.hash += sum;
      s.fieldHashes[field] = 0;  // for the next tick to add up
    }
    report.input = s.input;
    report.ship_x = m.ship.x;
    report.ship_y = m.ship.y;
    report.shipPrevious_x = m.ship.previous_x;
    report.shipPrevious_y = m.ship.previous_y;
    report.aim_rad = m.ship.aim_rad;
    report.score = m.score;
    report.kills = m.kills;
    report.multiplierTenths = m.multiplierTenths;
    report.frameTime_us = m.frameTime_us;
    report.bank_us = m.bank_us;
    report.flushes = m.flushes;
    report.flush_x = m.flush_x;
    report.flush_y = m.flush_y;
    report.flushRadius_m = m.flushRadius_m;
    report.untouchable_ticks = m.ship.untouchable_ticks;
    report.clock_ticks = m.clock_ticks;
    report.wave = m.wave + m.endless;
    report.pace = m.pace;
    report.rowsWidened = v.near.ngrid.totals ? v.near.ngrid.widened() : 0.0f;
    for (uint32_t t = 0; t < kMaxEnemyTypes; ++t) {
      report.enemies += m.totals.occupied[t];
      report.killsByType[t] = m.killsByType[t];
    }
    report.enemies -= m.totals.dying;
    report.shots = m.totals.occupied[kTypeShot];
    report.bits = m.totals.occupied[kTypeBit];
    report.enemiesInView = m.totals.inView;
    report.idle_ticks = m.idle_ticks;
    report.peakEnemies = larger(m.peakEnemies, report.enemies);
    report.refused = m.refused;
    report.bitsTaken = m.bitsTaken;
    report.contacts = m.contacts;
    report.contactType = s.contactType;
    report.contactCost_us = s.contactCost_us;
    // Once the game is over the totals do not change: they were reported when they were new.
    const Totals fresh = m.over ? Totals{} : m.totals;
    report.edges = s.tally.edges;
    sounds(report, fresh, s);
    pops(report, m, s);
  }

 private:
  GW_BODY static uint64_t globalsHash(const GameGlobals& m) {
    const uint32_t* words = reinterpret_cast<const uint32_t*>(&m);
    uint64_t sum = 0;
    for (uint32_t w = 0; w < sizeof(GameGlobals) / 4; w += 2)
      sum += hashWord(kNobody, w, uint64_t(words[w]) << 32 | words[w + 1]);
    return sum;
  }

  GW_BODY static void sounds(TickReport& report, const Totals& totals, const TickScratch& s) {
    constexpr uint32_t kMiddle = 1;
    const auto put = [&](SoundEvent event, uint32_t pan, uint32_t count) {
      report.sounds[uint32_t(event)][pan] = uint16_t(smaller(count, 65535u));
    };
    put(SoundEvent::shot, kMiddle, s.shotSounds);
    put(SoundEvent::contact, kMiddle, s.contactSounds);
    put(SoundEvent::bit, kMiddle, totals.bitsTaken);
    put(SoundEvent::wave, kMiddle, s.waveSounds);
    put(SoundEvent::flush, kMiddle, s.flushSounds);
    put(SoundEvent::over, kMiddle, s.overSounds);
    for (uint32_t type = 0; type < kMaxEnemyTypes; ++type) {
      for (uint32_t pan = 0; pan < kPans; ++pan) {
        report.killSounds[type][pan] = uint16_t(smaller(s.tally.killSounds[type][pan], 65535u));
      }
    }
  }

  GW_BODY void pops(TickReport& report, const GameGlobals& m, const TickScratch& s) const {
    for (uint32_t side = 0; side < kPans; ++side) {
      if (s.pops[side] == 0) continue;
      const uint32_t id = ~uint32_t(s.pops[side]);
      if (v.cellOf[id] >= v.capacity) continue;  // damaged, which the hash shows
      const Cell cell = v.moved[v.cellOf[id]];
      const uint64_t value = s.pops[side] >> 32;
      const bool bare = (v.state[id].w & kFlagFlushed) != 0;
      const uint64_t points = bare ? value : value * m.multiplierTenths / 10;
      report.pops[side] = {cell.x, cell.y, uint32_t(points < 0xFFFFFFFFull ? points : 0xFFFFFFFFull)};
    }
  }
};

}  // namespace

void report(Queue& queue, const View& view) {
  forEach(queue, Count{1}, Report{view});
}

}  // namespace gw::GW_DEVICE
