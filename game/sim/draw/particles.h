// Particles: the sparks of what dies, hits, is taken, touches the ship. Cosmetic only. They are kept in a ring
// of their own, outside the NGrid, the hash and snapshots, draw from a random purpose of their own, and
// nothing of the game reads them.
//
//   emitted so far modulo the ring's size
//            v
//   | newest | oldest ... | newest but one        the next birth takes the place of the oldest
//
// Births take their slots by rank: what is thrown is counted per source, ids first and the ship last, and a
// scan turns counts into ranks. So the ring's bytes depend on no order of visits.
#pragma once

#include <vector>

#include "game/sim/draw/particle.h"
#include "game/sim/state.h"

namespace gw::GW_DEVICE {

// Half a second of the thickest fight; twice that is never visible at once.
inline constexpr uint32_t kParticleRing = 16384;

struct ParticleView {
  const Particle* ring;
  const uint32_t* emitted;  // births so far, modulo 2^32
  uint32_t size;
};

class Particles {
 public:
  Particles() = default;
  // `size`, of the ring, is a power of two, so that the count of births may overflow.
  Particles(Queue& queue, uint32_t capacity, uint32_t size = kParticleRing);

  // The stage: throws what the events of this tick throw. `parity` is the tick's.
  void emit(Queue& queue, const View& view, uint32_t parity);

  // The ring before a tick of this parity.
  ParticleView view(uint32_t parity) const { return {ring_.data(), emitted_.data() + parity % 2, size_}; }
  // The same on the host: the newest last. Slots that were never filled are left out.
  std::vector<Particle> list(uint32_t parity) const;

  void clear();

 private:
  uint32_t size_ = 0, sources_ = 0;
  Buffer<Particle> ring_;
  Buffer<uint32_t> emitted_;  // by parity: a tick reads its own and writes the other
  Scan ranks_;
};

}  // namespace gw::GW_DEVICE
