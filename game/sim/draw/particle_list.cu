#include "game/sim/draw/particle_list.h"
#include "gpu/math/exact_math.h"

namespace gw::GW_DEVICE {
namespace {

constexpr float kFadesFrom = 0.5f;  // share of its life after which a particle's light goes down

// The ring as a frame sees it, by age: item 0 is the newest.
struct Seen {
  ParticleView particles;
  const GameGlobals* globals;
  DrawView window;
  float sinceTick_ticks;

  GW_MEMBER const Particle& at(uint32_t age) const {
    return particles.ring[(*particles.emitted - 1 - age) & (particles.size - 1)];
  }
  GW_MEMBER float age_ticks(const Particle& p) const { return float(globals->tick - p.birthTick) + sinceTick_ticks; }

  GW_MEMBER static Float2 placeAt(const Particle& p, float age_s) {
    const float way_s = (1.0f - exponential(-kParticleDrag_per_s * age_s)) / kParticleDrag_per_s;
    return {p.x + p.velocity_x * way_s, p.y + p.velocity_y * way_s};
  }

  GW_MEMBER bool shows(const Particle& p) const {
    const float age = age_ticks(p);
    if (p.life_ticks == 0 || age >= float(p.life_ticks)) return false;
    const Float2 head = placeAt(p, age * kTick_s);
    return magnitude(head.x - window.centre_x) <= window.halfWidth_m &&
           magnitude(head.y - window.centre_y) <= window.halfHeight_m;
  }
};

// Of one slot of the ring: 1 when it shows.
struct FindShown {
  Seen seen;
  GW_BODY uint64_t operator()(uint32_t age) const { return seen.shows(seen.at(age)) ? 1u : 0u; }
};

// One item: one slot of the ring; the first one also writes the command.
struct WriteStreaks {
  ParticleTarget target;
  ScanView ranks;
  Seen seen;

  GW_BODY void operator()(uint32_t age) const {
    if (age == 0) *target.command = {3, smaller(uint32_t(ranks.total()), target.vertexCapacity), 0, 0};
    if (!seen.shows(seen.at(age))) return;
    const uint32_t rank = uint32_t(ranks.before(age));
    if (rank < target.vertexCapacity) target.vertices[rank] = streak(seen.at(age));
  }

 private:
  GW_BODY ParticleVertex streak(const Particle& p) const {
    const float age = seen.age_ticks(p), age_s = age * kTick_s;
    const Float2 head = Seen::placeAt(p, age_s);
    const Float2 tail = Seen::placeAt(p, larger(age_s - kParticleStreak_s, 0.0f));
    const float left = 1.0f - age / float(p.life_ticks);
    const float light = smaller(left / (1.0f - kFadesFrom), 1.0f);
    return {head.x, head.y, tail.x, tail.y, p.size_m, light, p.colour};
  }
};

}  // namespace

ParticleList::ParticleList(Queue& queue, uint32_t size) : ranks_(queue, size) {}

void ParticleList::run(Queue& queue, const View& view, const ParticleView& particles, const DrawView& window,
                       float sinceTick_ticks, const ParticleTarget& target) {
  const Seen seen{particles, view.globals, window, sinceTick_ticks};
  ranks_.run(queue, FindShown{seen});
  forEach(queue, Count{particles.size}, WriteStreaks{target, ranks_.view(), seen});
}

}  // namespace gw::GW_DEVICE
