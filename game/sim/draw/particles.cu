#include "game/sim/draw/particles.h"
#include "game/sim/entity_flags.h"
#include "gpu/math/exact_math.h"
#include "gpu/math/philox.h"

namespace gw::GW_DEVICE {
namespace {

// What one source emits: a fan of streaks. docs/design/effects.md has the table.
struct Burst {
  uint32_t count;
  float x, y;                   // m
  float angle_rad, spread_rad;  // the middle of the fan, and how wide it is
  float slow_mps, fast_mps;
  uint32_t shortest_ticks, longest_ticks;  // lives
  float size_m;
  uint32_t colour;
};

// The ship's own sources, after the ids.
enum ShipSource : uint32_t { kShipLost, kContact, kFlush, kEngine, kShipSources };

constexpr float kEngineFrom_mps = 4;  // a slower ship leaves no trail
constexpr uint32_t kFewest = 8, kMost = 40;

GW_FN uint32_t deathCount(const EnemyRules& rules) {
  const float wanted = clamp(8.0f + 2.0f * rules.energy + 4.0f * rules.halfWidth_m, float(kFewest), float(kMost));
  return uint32_t(wanted);
}

GW_FN Burst entityBurst(const View& v, uint32_t id) {
  const Cell before = v.cells[v.cellOf[id]];
  const uint32_t event = v.event[id];
  if (isEnemy(before.type) && (event & kEventDied) && v.state[id].x == uint32_t(State::dead)) {
    const EnemyRules& rules = v.tables->rules.enemies[before.type];
    const Cell at = v.moved[v.cellOf[id]];
    const float size = clamp(rules.halfWidth_m, 0.3f, 1.2f);
    return {deathCount(rules),    at.x,        at.y, 0.0f, kTwoPi, 4.0f, 20.0f + 14.0f * size, 16, 42,
            0.07f + 0.07f * size, rules.colour};
  }
  if (before.type == kTypeShot && v.spent[id]) {
    const Float4 motion = v.velocityPrevious[id];
    const float until_s = v.choiceTime[id] * kTick_s;
    const float back = arcTangent2(-motion.y, -motion.x);
    return {
        3,          before.x + motion.x * until_s, before.y + motion.y * until_s, back, 1.8f, 5.0f, 16.0f, 6, 14, 0.05f,
        kShotColour};
  }
  if (before.type == kTypeBit && (event & kEventTaken)) {
    return {4, before.x, before.y, 0.0f, kTwoPi, 1.5f, 5.0f, 10, 20, 0.05f, kBitColour};
  }
  return Burst{};
}

GW_FN Burst shipBurst(const View& v, uint32_t source) {
  const Ship& ship = v.globals->ship;
  const TickScratch& s = *v.scratch;
  if (source == kShipLost && s.overSounds) {
    return {320, ship.x, ship.y, 0.0f, kTwoPi, 3.0f, 44.0f, 40, 110, 0.10f, 0x8FEBFF};
  }
  if (source == kContact && s.contactSounds) {
    return {96, ship.x, ship.y, 0.0f, kTwoPi, 6.0f, 40.0f, 18, 50, 0.09f, 0xFF4A5E};
  }
  if (v.globals->over) return Burst{};
  if (source == kFlush && s.flushSounds) {
    return {128, ship.x, ship.y, 0.0f, kTwoPi, 30.0f, 70.0f, 24, 44, 0.08f, 0x35E0FF};
  }
  if (source == kEngine && length(ship.velocity_x, ship.velocity_y) > kEngineFrom_mps) {
    const float back = arcTangent2(-ship.velocity_y, -ship.velocity_x);
    return {1, ship.x, ship.y, back, 0.9f, 3.0f, 9.0f, 12, 24, 0.06f, 0x2F8CFF};
  }
  return Burst{};
}

// A source is an id, or one of the ship's own behind them. Once the game is over events keep their last values.
GW_FN Burst burstOf(const View& v, uint32_t source) {
  if (source >= v.capacity) return shipBurst(v, source - v.capacity);
  return v.globals->over ? Burst{} : entityBurst(v, source);
}

// How many one source throws.
struct CountEmitted {
  View v;
  GW_BODY uint64_t operator()(uint32_t source) const { return burstOf(v, source).count; }
};

// One item: one source, which writes its particles; the last one also moves the ring on.
struct EmitParticles {
  Particle* ring;
  uint32_t* emittedAfter;
  const uint32_t* emitted;
  ScanView ranks;
  View v;
  uint32_t size, sources;

  GW_BODY void operator()(uint32_t source) const {
    const uint32_t total = uint32_t(ranks.total());
    if (source == sources - 1) *emittedAfter = *emitted + total;
    const Burst burst = burstOf(v, source);
    const uint32_t first = uint32_t(ranks.before(source));
    for (uint32_t k = 0; k < burst.count; ++k) {
      if (total - (first + k) > size) continue;  // more than fit in one tick: the last ones stay
      ring[(*emitted + first + k) & (size - 1)] = particle(burst, source, k);
    }
  }

 private:
  GW_BODY Particle particle(const Burst& burst, uint32_t source, uint32_t k) const {
    const Uint4 dice = philox(v.globals->seed, {v.globals->tick, source, kPurposeParticles, k});
    const float place = (float(k) + unitFloat(dice.x)) / float(burst.count) - 0.5f;  // evenly round the fan
    const SineCosine way = sineCosine(burst.angle_rad + place * burst.spread_rad);
    const float speed = burst.slow_mps + (burst.fast_mps - burst.slow_mps) * unitFloat(dice.y);
    Particle p;
    p.x = burst.x;
    p.y = burst.y;
    p.velocity_x = way.cosine * speed;
    p.velocity_y = way.sine * speed;
    p.birthTick = v.globals->tick;
    p.life_ticks = burst.shortest_ticks + dice.z % (burst.longest_ticks - burst.shortest_ticks + 1);
    p.colour = burst.colour;
    p.size_m = burst.size_m * (0.7f + 0.6f * unitFloat(dice.w));
    return p;
  }
};

}  // namespace

Particles::Particles(Queue& queue, uint32_t capacity, uint32_t size)
    : size_(size), sources_(capacity + kShipSources), ring_(queue, size), emitted_(queue, 2), ranks_(queue, sources_) {}

void Particles::emit(Queue& queue, const View& view, uint32_t parity) {
  ranks_.run(queue, CountEmitted{view});
  forEach(queue, Count{sources_},
          EmitParticles{ring_.data(), emitted_.data() + (parity + 1) % 2, emitted_.data() + parity % 2, ranks_.view(),
                        view, size_, sources_});
}

std::vector<Particle> Particles::list(uint32_t parity) const {
  const std::vector<Particle> ring = ring_.download();
  uint32_t emitted = 0;
  emitted_.download(&emitted, 1, parity % 2);
  std::vector<Particle> list;
  for (uint32_t age = 0; age < size_; ++age) {
    const Particle& p = ring[(emitted + age) & (size_ - 1)];
    if (p.life_ticks > 0) list.push_back(p);
  }
  return list;
}

void Particles::clear() {
  ring_.upload(std::vector<Particle>(size_));
  emitted_.upload(std::vector<uint32_t>(2));
}

}  // namespace gw::GW_DEVICE
