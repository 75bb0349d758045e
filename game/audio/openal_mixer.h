// The mixer on an OpenAL device: one source a voice, one for the music, all relative to the listener.
#pragma once

#include <AL/al.h>
#include <AL/alc.h>

#include <array>

#include "game/audio/mixer.h"

namespace gw {

class OpenalMixer : public Mixer {
 public:
  // Owns the open device from here on. `attributes` as alcCreateContext takes them, may be null. Throws
  // std::runtime_error when the device has not got the sources.
  OpenalMixer(ALCdevice* device, const ALCint* attributes, const SoundBank& bank);
  ~OpenalMixer() override;
  OpenalMixer(const OpenalMixer&) = delete;
  OpenalMixer& operator=(const OpenalMixer&) = delete;

  bool start(const VoiceStart& start) override;
  std::optional<float> position_s(uint32_t voice) const override;
  void setEffects(float gain) override;
  void setMusic(float gain, float pitch) override;
  bool connected() const override;

 private:
  void close();
  ALuint upload(const Clip& clip);

  ALCdevice* device_;
  ALCcontext* context_ = nullptr;
  bool reportsLoss_ = false;  // ALC_EXT_disconnect
  std::array<ALuint, Voices::kVoices> sources_{};
  std::array<float, Voices::kVoices> startGain_{};
  std::array<ALuint, kSounds> buffers_{};
  ALuint musicSource_ = 0, musicBuffer_ = 0;
  float effects_ = 1;
};

}  // namespace gw
