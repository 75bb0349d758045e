#include "tests/reference/sim_particles.h"

#include <algorithm>
#include <cmath>

#include "gpu/math/exact_math.h"
#include "gpu/math/philox.h"

namespace gw::naive {
namespace {

constexpr uint32_t kPurpose = 64;
constexpr float kTurn = 6.28318530717959f;

struct Table {
  uint32_t count;
  float spread, slow, fast;
  uint32_t shortest, longest;
  float size;
  uint32_t colour;
};

struct Thrower {
  const GameGlobals& globals;
  std::vector<Particle> all;

  void fan(uint32_t source, float x, float y, float middle, const Table& t) {
    for (uint32_t k = 0; k < t.count; ++k) {
      const Uint4 dice = cpu::philox(globals.seed, {globals.tick, source, kPurpose, k});
      const float share = (float(k) + cpu::unitFloat(dice.x)) / float(t.count) - 0.5f;
      const float angle = middle + share * t.spread;
      const float speed = t.slow + (t.fast - t.slow) * cpu::unitFloat(dice.y);
      all.push_back({x, y, cpu::cosine(angle) * speed, cpu::sine(angle) * speed, globals.tick,
                     t.shortest + dice.z % (t.longest - t.shortest + 1), t.colour,
                     t.size * (0.7f + 0.6f * cpu::unitFloat(dice.w))});
    }
  }
};

}  // namespace

std::vector<Particle> thrown(const World& world, const std::vector<Happened>& happened, const TickScratch& scratch) {
  const Ship& ship = world.globals.ship;
  const uint32_t n = world.limits.capacity;
  Thrower thrower{world.globals, {}};
  if (!world.globals.over) {
    for (const Happened& h : happened) {
      if (h.what == Happened::death) {
        const EnemyRules& rules = world.rules.enemies[h.type];
        const float wanted = 8.0f + 2.0f * rules.energy + 4.0f * rules.halfWidth_m;
        const float size = std::min(std::max(rules.halfWidth_m, 0.3f), 1.2f);
        thrower.fan(h.id, h.x, h.y, 0.0f,
                    {uint32_t(std::min(std::max(wanted, 8.0f), 40.0f)), kTurn, 4.0f, 20.0f + 14.0f * size, 16, 42,
                     0.07f + 0.07f * size, rules.colour});
      } else if (h.what == Happened::hit) {
        thrower.fan(h.id, h.x, h.y, cpu::arcTangent2(-h.motion_y, -h.motion_x),
                    {3, 1.8f, 5.0f, 16.0f, 6, 14, 0.05f, 0xFFF3B0});
      } else {
        thrower.fan(h.id, h.x, h.y, 0.0f, {4, kTurn, 1.5f, 5.0f, 10, 20, 0.05f, 0x7CFFCB});
      }
    }
  }
  if (scratch.overSounds) {
    thrower.fan(n, ship.x, ship.y, 0.0f, {320, kTurn, 3.0f, 44.0f, 40, 110, 0.10f, 0x8FEBFF});
  }
  if (scratch.contactSounds) {
    thrower.fan(n + 1, ship.x, ship.y, 0.0f, {96, kTurn, 6.0f, 40.0f, 18, 50, 0.09f, 0xFF4A5E});
  }
  if (world.globals.over) return thrower.all;
  if (scratch.flushSounds) {
    thrower.fan(n + 2, ship.x, ship.y, 0.0f, {128, kTurn, 30.0f, 70.0f, 24, 44, 0.08f, 0x35E0FF});
  }
  const float fast2 = ship.velocity_x * ship.velocity_x + ship.velocity_y * ship.velocity_y;
  if (std::sqrt(fast2) > 4.0f) {
    thrower.fan(n + 3, ship.x, ship.y, cpu::arcTangent2(-ship.velocity_y, -ship.velocity_x),
                {1, 0.9f, 3.0f, 9.0f, 12, 24, 0.06f, 0x2F8CFF});
  }
  return thrower.all;
}

}  // namespace gw::naive
