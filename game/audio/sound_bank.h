// The sounds in memory. A file that is missing or damaged costs that sound only, and one sentence.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "game/audio/sounds.h"

namespace gw {

struct Clip {
  uint32_t rate_hz = 0;
  std::vector<int16_t> samples;  // one channel; empty: there is no such sound
};

// Takes a sentence for the user.
using Say = std::function<void(const std::string&)>;

// 16-bit PCM, one channel, 8,000 to 96,000 Hz. Throws std::runtime_error that says what is wrong with the bytes.
Clip parseWav(const std::vector<uint8_t>& bytes);

struct SoundBank {
  std::array<Clip, kSounds> effects;
  Clip music;
};

// For each 1/60 s of the clip the peak from there to its end, as a share of full scale.
std::vector<float> peaksFrom(const Clip& clip);

// <folder>/<name>.wav of every sound, and music.wav.
SoundBank loadSounds(const std::filesystem::path& folder, const Say& say);

}  // namespace gw
