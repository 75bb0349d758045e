#include "tests/game/audio/audio_listener.h"

#include <AL/alext.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "game/tables/tables.h"

namespace gw::test {

namespace {

ALCdevice* openLoopback() {
  const auto open =
      reinterpret_cast<LPALCLOOPBACKOPENDEVICESOFT>(alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
  ALCdevice* device = open ? open(nullptr) : nullptr;
  if (!device) throw std::runtime_error("OpenAL has no loopback device: install OpenAL Soft");
  return device;
}

std::vector<float> part(const std::vector<float>& samples, double from_s, double to_s) {
  const auto at = [&](double s) { return samples.begin() + std::min(samples.size(), size_t(s * kListenRate_hz)); };
  return {at(from_s), at(to_s)};
}

}  // namespace

float Heard::peak() const {
  float most = 0;
  for (const auto* side : {&left, &right}) {
    for (const float sample : *side) most = std::max(most, std::abs(sample));
  }
  return most;
}

double Heard::rms() const {
  const double l = rmsOf(left), r = rmsOf(right);
  return std::sqrt((l * l + r * r) / 2);
}

Heard Heard::between(double from_s, double to_s) const {
  return {part(left, from_s, to_s), part(right, from_s, to_s)};
}

double rmsOf(const std::vector<float>& samples) {
  double sum = 0;
  for (const float sample : samples) sum += double(sample) * sample;
  return std::sqrt(sum / std::max<size_t>(samples.size(), 1));
}

double amplitudeAt(const std::vector<float>& samples, double frequency_hz) {
  const double turn = 2 * std::numbers::pi * frequency_hz / kListenRate_hz;
  double real = 0, imaginary = 0;
  for (size_t i = 0; i < samples.size(); ++i) {
    real += samples[i] * std::cos(turn * double(i));
    imaginary += samples[i] * std::sin(turn * double(i));
  }
  return 2 * std::hypot(real, imaginary) / double(samples.size());
}

double dominantFrequency(const std::vector<float>& samples, double lowest_hz, double highest_hz) {
  double best = 0, bestAmplitude = -1;
  for (double f = lowest_hz; f <= highest_hz; f *= std::exp2(1.0 / 48)) {
    const double amplitude = amplitudeAt(samples, f);
    if (amplitude > bestAmplitude) best = f, bestAmplitude = amplitude;
  }
  return best;
}

Listener::Listener(const SoundBank& bank) : device_(openLoopback()) {
  const ALCint attributes[] = {ALC_FREQUENCY,
                               ALCint(kListenRate_hz),
                               ALC_FORMAT_CHANNELS_SOFT,
                               ALC_STEREO_SOFT,
                               ALC_FORMAT_TYPE_SOFT,
                               ALC_FLOAT_SOFT,
                               ALC_HRTF_SOFT,
                               ALC_FALSE,
                               0};
  mixer_ = std::make_unique<OpenalMixer>(device_, attributes, bank);
}

Heard Listener::listen(double seconds) {
  static const auto render =
      reinterpret_cast<LPALCRENDERSAMPLESSOFT>(alcGetProcAddress(nullptr, "alcRenderSamplesSOFT"));
  const size_t count = size_t(seconds * kListenRate_hz + 0.5);
  std::vector<float> both(2 * count);
  render(device_, both.data(), ALCsizei(count));
  Heard heard;
  for (size_t i = 0; i < count; ++i) {
    heard.left.push_back(both[2 * i]);
    heard.right.push_back(both[2 * i + 1]);
  }
  return heard;
}

const SoundBank& gameSounds() {
  static const SoundBank bank = loadSounds(std::filesystem::path(GW_ASSETS_DIR) / "sounds",
                                           [](const std::string& sentence) { ADD_FAILURE() << sentence; });
  return bank;
}

const Rules& gameRules() {
  static const Rules rules = loadRules(readRuleTexts(GW_ASSETS_DIR));
  return rules;
}

}  // namespace gw::test
