// Listens to the mixer through OpenAL's loopback device: the same samples every run, and no sound card.
#pragma once

#include <memory>
#include <vector>

#include "game/audio/openal_mixer.h"

namespace gw::test {

inline constexpr uint32_t kListenRate_hz = 48000;

// What a stereo listener got.
struct Heard {
  std::vector<float> left, right;

  float peak() const;
  double rms() const;  // of both sides
  // The part from one second to another.
  Heard between(double from_s, double to_s) const;
};

double rmsOf(const std::vector<float>& samples);
// How much of that frequency there is, as the amplitude of a sine (Goertzel).
double amplitudeAt(const std::vector<float>& samples, double frequency_hz);
// Of the frequencies from lowest to highest, in steps of a quarter of a semitone, the strongest.
double dominantFrequency(const std::vector<float>& samples, double lowest_hz, double highest_hz);

class Listener {
 public:
  explicit Listener(const SoundBank& bank);

  // The mixer of a device of its own; may be called once, the caller keeps the mixer while listening.
  std::unique_ptr<OpenalMixer> takeMixer() { return std::move(mixer_); }
  Heard listen(double seconds);

 private:
  ALCdevice* device_;
  std::unique_ptr<OpenalMixer> mixer_;
};

// The game's own sounds.
const SoundBank& gameSounds();
const Rules& gameRules();

}  // namespace gw::test
