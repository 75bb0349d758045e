// The sounds of the game as one table: where each comes from and how loud it wants to be.
#pragma once

#include <array>
#include <cstdint>

namespace gw {

// Heavy kills are those of types that the ship's blast does not take (EnemyRules::energy > Ship::weakEnergy).
enum class Sound : uint32_t { shot, kill, killHeavy, bit, wave, flush, contact, over, count };
inline constexpr uint32_t kSounds = uint32_t(Sound::count);

// Alarms have head room of their own, so that no horde can drown what the player must hear.
enum class Bus : uint32_t { work, alarm, count };

struct SoundTraits {
  const char* name;  // assets/sounds/<name>.wav
  Bus bus;
  float gain;              // of one event, before volumes; files reach 0.85 of full scale
  uint32_t spacing_ticks;  // events nearer to the last start join the next one
};

inline constexpr std::array<SoundTraits, kSounds> kSoundTraits{{
    {"shot", Bus::work, 0.120f, 4},  // ten a second all game long: the quietest
    {"kill", Bus::work, 0.250f, 4},
    {"kill_heavy", Bus::work, 0.340f, 4},
    {"bit", Bus::work, 0.120f, 4},
    {"wave", Bus::alarm, 0.180f, 30},
    {"flush", Bus::alarm, 0.300f, 10},
    {"contact", Bus::alarm, 0.340f, 10},
    {"over", Bus::alarm, 0.360f, 60},
}};

constexpr const SoundTraits& traitsOf(Sound sound) {
  return kSoundTraits[uint32_t(sound)];
}

// What may sound at once: the sum, over the voices of a bus, of gain times what the sample still reaches. A source
// in the middle reaches each speaker with 0.6 of that, one at the side its speaker with 0.87; alarms and music stand
// in the middle. At full volumes: 0.87 x 0.46 + 0.6 x (0.44 + 0.50) = 0.96 of what a speaker takes.
inline constexpr float kWorkHeadroom = 0.46f, kAlarmHeadroom = 0.44f, kMusicGain = 0.50f;

}  // namespace gw
