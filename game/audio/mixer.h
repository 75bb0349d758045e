// What the game needs of whatever plays its voices.
#pragma once

#include <memory>
#include <optional>

#include "game/audio/sound_bank.h"
#include "game/audio/voices.h"

namespace gw {

class Mixer {
 public:
  virtual ~Mixer() = default;

  // Plays it on its voice, in place of what that played. False when there is no such sound.
  virtual bool start(const VoiceStart& start) = 0;
  // How far a voice is, in seconds of its file; none when it does not play.
  virtual std::optional<float> position_s(uint32_t voice) const = 0;

  // Scales everything that plays and will play; music at gain 0 goes on unheard.
  virtual void setEffects(float gain) = 0;
  virtual void setMusic(float gain, float pitch) = 0;

  // False once the device is gone for good.
  virtual bool connected() const = 0;
};

// Plays on this machine's own device; null when there is none.
std::unique_ptr<Mixer> openMixer(const SoundBank& bank);

}  // namespace gw
