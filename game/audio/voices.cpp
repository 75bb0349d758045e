#include "game/audio/voices.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gw {

namespace {

constexpr float kLoudest = 2.5f;        // most that many events are louder than one
constexpr uint32_t kStreak_ticks = 30;  // bits nearer to each other climb the scale
// Of the head room still free a start may take this share, so that the next one finds some too.
constexpr float kShare[] = {0.5f, 0.75f};

float semitones(int steps) {
  return std::exp2(float(steps) / 12);
}

bool lighter(const EnemyRules& a, const EnemyRules& b) {
  return a.mass != b.mass ? a.mass < b.mass : a.energy < b.energy;
}

uint32_t sumOf(const uint16_t (&counts)[kPans]) {
  return counts[0] + counts[1] + counts[2];
}

}  // namespace

float loudnessOf(uint32_t count) {
  return std::min(kLoudest, 1 + 0.25f * std::log2(float(std::max(count, 1u))));
}

float killPitch(const Rules& rules, uint32_t type) {
  constexpr int kScale[kMaxEnemyTypes] = {10, 7, 5, 0, -2, -5, -9, -14};  // semitones from A4
  uint32_t rank = 0;
  for (uint32_t other = 0; other < rules.enemyTypeCount; ++other) {
    const bool before = lighter(rules.enemies[other], rules.enemies[type]);
    const bool after = lighter(rules.enemies[type], rules.enemies[other]);
    rank += before || (!after && other < type);
  }
  // Few types spread over the whole scale.
  const uint32_t last = std::max(rules.enemyTypeCount, 2u) - 1;
  return semitones(kScale[std::min(rank, last) * (kMaxEnemyTypes - 1) / last]);
}

const std::vector<VoiceStart>& Voices::hear(const TickReport& report, const Rules& rules) {
  starts_.clear();
  cutOffSlot_ = (cutOffSlot_ + 1) % kCutOff_ticks;
  for (auto& slots : cutOff_) slots[cutOffSlot_] = 0;
  hearEvent(SoundEvent::over, Sound::over, report);
  hearEvent(SoundEvent::contact, Sound::contact, report);
  hearEvent(SoundEvent::flush, Sound::flush, report);
  hearEvent(SoundEvent::wave, Sound::wave, report);
  hearKills(report, rules);
  hearEvent(SoundEvent::bit, Sound::bit, report);
  hearEvent(SoundEvent::shot, Sound::shot, report);
  return starts_;
}

void Voices::hearEvent(SoundEvent event, Sound sound, const TickReport& report) {
  const auto& counts = report.sounds[uint32_t(event)];
  if (event == SoundEvent::bit && sumOf(counts) > 0) {
    bitStreak_ = report.tick - lastBit_tick_ <= kStreak_ticks ? bitStreak_ : 0;
    lastBit_tick_ = report.tick;
  }
  for (uint32_t pan = 0; pan < kPans; ++pan) {
    Waiting& waiting = events_[uint32_t(event)][pan];
    waiting.count += counts[pan];
    waiting.rest_ticks -= waiting.rest_ticks > 0;
    if (waiting.count == 0 || waiting.rest_ticks > 0) continue;
    if (start(sound, Side(pan), waiting.count, pitchOf(sound, report.tick, waiting.count))) {
      waiting = {0, traitsOf(sound).spacing_ticks};
    }
  }
}

float Voices::pitchOf(Sound sound, uint32_t tick, uint32_t count) {
  if (sound == Sound::bit) {
    constexpr int kClimb[] = {0, 3, 5, 7, 10, 12};
    const float pitch = semitones(kClimb[std::min<uint32_t>(bitStreak_ / 4, 5)]);
    bitStreak_ += std::min(count, 4u);
    return pitch;
  }
  // The same shot ten times a second would be a buzz of its own pitch.
  if (sound == Sound::shot) return 0.97f + 0.02f * float((tick * 2654435761u) >> 30);
  return 1;
}

void Voices::hearKills(const TickReport& report, const Rules& rules) {
  struct Group {
    uint32_t type, pan;
    float weight;
  };
  std::array<Group, kMaxEnemyTypes * kPans> ready;
  uint32_t count = 0;
  for (uint32_t type = 0; type < rules.enemyTypeCount; ++type) {
    for (uint32_t pan = 0; pan < kPans; ++pan) {
      Waiting& waiting = kills_[type][pan];
      waiting.count += report.killSounds[type][pan];
      waiting.rest_ticks -= waiting.rest_ticks > 0;
      if (waiting.count == 0 || waiting.rest_ticks > 0) continue;
      ready[count++] = {type, pan, float(waiting.count) * rules.enemies[type].energy};
    }
  }
  // The weightiest first; what waits grows, so nothing waits for long.
  std::stable_sort(ready.begin(), ready.begin() + count,
                   [](const Group& a, const Group& b) { return a.weight > b.weight; });
  for (uint32_t k = 0; k < std::min(count, kMostKillStarts); ++k) {
    const Group& group = ready[k];
    Waiting& waiting = kills_[group.type][group.pan];
    const bool heavy = rules.enemies[group.type].energy > rules.ship.weakEnergy;
    const Sound sound = heavy ? Sound::killHeavy : Sound::kill;
    if (start(sound, Side(group.pan), waiting.count, killPitch(rules, group.type))) {
      waiting = {0, traitsOf(sound).spacing_ticks};
    }
  }
}

float Voices::used(Bus bus) const {
  const auto& slots = cutOff_[uint32_t(bus)];
  float sum = std::accumulate(slots.begin(), slots.end(), 0.0f);
  for (const Voice& voice : voices_) {
    if (voice.busy && traitsOf(voice.sound).bus == bus) sum += voice.gain * voice.peak;
  }
  return sum;
}

float Voices::peakOf(Sound sound, float position_s) const {
  const std::vector<float>& peaks = peaks_[uint32_t(sound)];
  if (peaks.empty()) return 1;
  return peaks[std::min(size_t(std::max(0.0f, position_s) * 60), peaks.size() - 1)];
}

void Voices::reached(uint32_t voice, float position_s) {
  Voice& v = voices_[voice];
  v.peak = std::min(v.peak, peakOf(v.sound, position_s));
}

// A free voice, or the oldest of the work: it has decayed most. Alarms are cut off by alarms only.
uint32_t Voices::takeVoice(Bus bus) {
  uint32_t oldest = kVoices;
  for (uint32_t v = 0; v < kVoices; ++v) {
    if (!voices_[v].busy) return v;
    if (traitsOf(voices_[v].sound).bus == Bus::alarm && bus == Bus::work) continue;
    const auto key = [&](uint32_t i) { return std::pair(traitsOf(voices_[i].sound).bus, voices_[i].startedAs); };
    if (oldest == kVoices || key(v) < key(oldest)) oldest = v;
  }
  return oldest;
}

bool Voices::start(Sound sound, Side side, uint32_t count, float pitch) {
  const SoundTraits& traits = traitsOf(sound);
  const uint32_t voice = takeVoice(traits.bus);
  if (voice == kVoices) return false;
  if (const Voice& cut = voices_[voice]; cut.busy) {
    cutOff_[uint32_t(traitsOf(cut.sound).bus)][cutOffSlot_] += cut.gain * cut.peak;
  }
  voices_[voice].busy = false;
  const float headroom = traits.bus == Bus::work ? kWorkHeadroom : kAlarmHeadroom;
  const float free = std::max(0.0f, headroom - used(traits.bus));
  const float peak = std::max(peakOf(sound, 0), 0.01f);
  const float gain = std::min(traits.gain * loudnessOf(count), free * kShare[uint32_t(traits.bus)] / peak);
  voices_[voice] = {true, sound, gain, peak, ++started_};
  starts_.push_back({voice, sound, side, gain, pitch});
  return true;
}

}  // namespace gw
