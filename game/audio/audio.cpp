#include "game/audio/audio.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace gw {

namespace {

constexpr float kFade_s = 0.25f;  // from full to nothing, between scenes

float closer(float from, float to, float most) {
  return from < to ? std::min(to, from + most) : std::max(to, from - most);
}

}  // namespace

Audio::Audio(const std::filesystem::path& assets, const Settings::Sound& settings, bool muted, OpenMixer open, Say say)
    : folder_(assets / "sounds"),
      settings_(settings),
      open_(std::move(open)),
      say_(std::move(say)),
      muted_(muted || settings.muted) {}

Audio::~Audio() = default;

void Audio::sayOnStderr(const std::string& sentence) {
  std::fprintf(stderr, "%s\n", sentence.c_str());
}

void Audio::hear(const TickReport& report, const Rules& rules) {
  stutter_ = stutter(report.tick, report.frameTime_us, rules);
  if (!mixer_ || muted_) return;
  for (const VoiceStart& start : voices_.hear(report, rules)) {
    if (!mixer_->start(start)) voices_.ended(start.voice);
  }
}

void Audio::update(Scene scene, float passed_s) {
  if (!muted_ && !mixer_ && !tried_) open();
  if (!mixer_) return;
  if (!mixer_->connected()) {
    loseDevice();
    if (!mixer_) return;
  }
  for (uint32_t v = 0; v < Voices::kVoices; ++v) {
    if (!voices_.busy(v)) continue;
    const std::optional<float> position_s = mixer_->position_s(v);
    position_s ? voices_.reached(v, *position_s) : voices_.ended(v);
  }
  const float most = std::max(0.0f, passed_s) / kFade_s;
  music_ = closer(music_, musicLevel(scene), most);
  effects_ = closer(effects_, effectsLevel(scene), most);
  const Stutter now = scene == Scene::play ? stutter_ : Stutter{};
  const float heard = muted_ ? 0.0f : 1.0f;
  mixer_->setEffects(heard * settings_.effects * effects_);
  mixer_->setMusic(heard * settings_.music * kMusicGain * music_ * now.gain, now.pitch);
}

void Audio::setVolumes(const Settings::Sound& settings) {
  settings_ = settings;
}

void Audio::setMuted(bool muted) {
  if (muted_ && !muted) tried_ = false;
  muted_ = settings_.muted = muted;
}

void Audio::open() {
  tried_ = true;
  if (!bank_) bank_ = loadSounds(folder_, say_);
  mixer_ = open_(*bank_);
  startVoices();
  if (!mixer_) {
    say_(
        "There is no sound device, so the game goes on silently: --mute saves this line, and pressing M twice in "
        "the game tries again.");
  }
}

// All silent, and knowing what each sound reaches.
void Audio::startVoices() {
  Voices::Peaks peaks;
  for (uint32_t s = 0; s < kSounds; ++s) peaks[s] = peaksFrom(bank_->effects[s]);
  voices_ = Voices(std::move(peaks));
}

void Audio::loseDevice() {
  mixer_.reset();
  startVoices();
  if (!muted_) mixer_ = open_(*bank_);  // another card may have taken over
  if (!mixer_) {
    tried_ = true;
    say_("The sound device is gone, so the game goes on silently: pressing M twice tries again.");
  }
}

}  // namespace gw
