// Which sounds start in a tick. Pure: reports go in, at most kVoices numbered voices come out, so that 500 kills
// in a tick cost no more than four and what sounds together stays within the head room. Needs no OpenAL.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "game/audio/sounds.h"
#include "game/sim/simulation.h"

namespace gw {

enum class Side : uint32_t { left, middle, right };

struct VoiceStart {
  uint32_t voice = 0;  // a voice that still sounds is cut off: it was stolen
  Sound sound = Sound::shot;
  Side side = Side::middle;
  float gain = 0;
  float pitch = 1;
};

class Voices {
 public:
  static constexpr uint32_t kVoices = 24;
  static constexpr uint32_t kMostKillStarts = 4;  // a tick; the others wait and sound together
  // A voice that is cut off keeps its head room for so long: OpenAL 1.21 and newer fade it out, over 64 samples, while
  // its successor already plays, and both begin with the device's next update, which may be 40 ms away.
  static constexpr uint32_t kCutOff_ticks = 3;

  // The starts of one tick, the most important first. Valid until the next call.
  const std::vector<VoiceStart>& hear(const TickReport& report, const Rules& rules);

  // What each sound reaches from each 1/60 s of it on (peaksFrom); without, all of full scale to the end.
  using Peaks = std::array<std::vector<float>, kSounds>;
  explicit Voices(Peaks peaks = {}) : peaks_(std::move(peaks)) {}

  // How far a voice has got, in seconds of its file, and that it has got to its end: its head room is free again.
  void reached(uint32_t voice, float position_s);
  void ended(uint32_t voice) { voices_[voice].busy = false; }
  bool busy(uint32_t voice) const { return voices_[voice].busy; }
  float used(Bus bus) const;  // of the bus's head room, by what sounds or was just cut off

 private:
  struct Voice {
    bool busy = false;
    Sound sound = Sound::shot;
    float gain = 0;
    float peak = 1;          // what the sample still reaches
    uint64_t startedAs = 0;  // count of starts
  };
  // Events of one kind and side that wait for their spacing.
  struct Waiting {
    uint32_t count = 0;
    uint32_t rest_ticks = 0;  // until it may start again
  };

  void hearEvent(SoundEvent event, Sound sound, const TickReport& report);
  void hearKills(const TickReport& report, const Rules& rules);
  bool start(Sound sound, Side side, uint32_t count, float pitch);
  uint32_t takeVoice(Bus bus);
  float pitchOf(Sound sound, uint32_t tick, uint32_t count);

  float peakOf(Sound sound, float position_s) const;

  Peaks peaks_;
  std::array<Voice, kVoices> voices_{};
  std::array<std::array<float, kCutOff_ticks>, uint32_t(Bus::count)> cutOff_{};  // in each of the last ticks
  uint32_t cutOffSlot_ = 0;                                                      // of this tick
  std::array<std::array<Waiting, kPans>, uint32_t(SoundEvent::count)> events_{};
  std::array<std::array<Waiting, kPans>, kMaxEnemyTypes> kills_{};
  std::vector<VoiceStart> starts_;
  uint64_t started_ = 0;
  uint32_t bitStreak_ = 0, lastBit_tick_ = 0;
};

// How many times as loud `count` events together are as one: 1 for one, growing with the logarithm.
float loudnessOf(uint32_t count);

// The pitch of a type's kill: the types ordered by mass, then energy, fall along a minor pentatonic scale, which
// the music shares. So a horde plays a tune, and a big one is known by ear.
float killPitch(const Rules& rules, uint32_t type);

}  // namespace gw
