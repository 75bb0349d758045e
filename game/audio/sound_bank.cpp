#include "game/audio/sound_bank.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace gw {

namespace fs = std::filesystem;

namespace {

constexpr uintmax_t kMostBytes = 32u << 20;  // five minutes of music

uint32_t word(const std::vector<uint8_t>& bytes, size_t at, uint32_t size) {
  uint32_t value = 0;
  for (uint32_t i = 0; i < size; ++i) value |= uint32_t(bytes[at + i]) << (8 * i);
  return value;
}

bool tagged(const std::vector<uint8_t>& bytes, size_t at, const char* tag) {
  return std::equal(tag, tag + 4, bytes.begin() + ptrdiff_t(at));
}

void require(bool fine, const std::string& problem) {
  if (!fine) throw std::runtime_error(problem);
}

void readFormat(Clip& clip, const std::vector<uint8_t>& bytes, size_t at, size_t size) {
  require(size >= 16, "has a format chunk that is too short");
  const uint32_t format = word(bytes, at, 2), channels = word(bytes, at + 2, 2), bits = word(bytes, at + 14, 2);
  clip.rate_hz = word(bytes, at + 4, 4);
  require(format == 1 && bits == 16, "holds no 16-bit PCM");
  require(channels == 1, "has " + std::to_string(channels) + " channels where one is needed");
  require(clip.rate_hz >= 8000 && clip.rate_hz <= 96000,
          "has " + std::to_string(clip.rate_hz) + " samples a second, which is outside 8000 to 96000");
}

void readSamples(Clip& clip, const std::vector<uint8_t>& bytes, size_t at, size_t size) {
  require(size > 0, "holds no samples");
  require(size % 2 == 0, "ends in the middle of a sample");
  clip.samples.resize(size / 2);
  for (size_t i = 0; i < clip.samples.size(); ++i) clip.samples[i] = int16_t(uint16_t(word(bytes, at + 2 * i, 2)));
}

std::vector<uint8_t> readFile(const fs::path& path) {
  std::error_code error;
  require(fs::exists(path, error), "is missing");
  require(fs::is_regular_file(path, error), "is no file");
  const uintmax_t size = fs::file_size(path, error);
  require(!error && size <= kMostBytes, "is larger than 32 MiB");
  std::ifstream file(path, std::ios::binary);
  std::vector<uint8_t> bytes(size);
  file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
  require(bool(file), "cannot be read");
  return bytes;
}

void load(Clip& clip, const fs::path& path, const Say& say) {
  try {
    clip = parseWav(readFile(path));
  } catch (const std::runtime_error& problem) {
    say("The sound " + path.string() + " " + problem.what() +
        ", so the game goes on without it: restore it, or make it again with tools/make_sounds.py.");
  }
}

}  // namespace

Clip parseWav(const std::vector<uint8_t>& bytes) {
  require(bytes.size() >= 12 && tagged(bytes, 0, "RIFF") && tagged(bytes, 8, "WAVE"), "is no WAV file");
  Clip clip;
  size_t at = 12;
  while (bytes.size() - at >= 8) {
    const size_t size = word(bytes, at + 4, 4), left = bytes.size() - at - 8;
    require(size <= left, "is cut off");
    if (tagged(bytes, at, "fmt ")) readFormat(clip, bytes, at + 8, size);
    if (tagged(bytes, at, "data")) {
      require(clip.rate_hz != 0, "has samples before their format");
      readSamples(clip, bytes, at + 8, size);
      return clip;
    }
    at += 8 + std::min(left, size + size % 2);  // chunks begin at even places
  }
  throw std::runtime_error("holds no samples");
}

std::vector<float> peaksFrom(const Clip& clip) {
  if (clip.samples.empty()) return {};
  std::vector<float> peaks(clip.samples.size() * 60 / clip.rate_hz + 1, 0.0f);
  float peak = 0;
  for (size_t i = clip.samples.size(); i-- > 0;) {
    peak = std::max(peak, std::abs(float(clip.samples[i])) / 32768);
    peaks[i * 60 / clip.rate_hz] = peak;
  }
  return peaks;
}

SoundBank loadSounds(const fs::path& folder, const Say& say) {
  SoundBank bank;
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    say("The folder " + folder.string() +
        " is missing, so the game goes on without its sounds: restore it, or make it again with tools/make_sounds.py.");
    return bank;
  }
  for (uint32_t s = 0; s < kSounds; ++s) {
    load(bank.effects[s], folder / (std::string(kSoundTraits[s].name) + ".wav"), say);
  }
  load(bank.music, folder / "music.wav", say);
  return bank;
}

}  // namespace gw
