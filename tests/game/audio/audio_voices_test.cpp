// Which sounds start: budgets, merging, stealing, and pitch. No OpenAL here.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <set>

#include "game/audio/voices.h"
#include "tests/game/audio/audio_listener.h"

namespace gw::test {
namespace {

TickReport quietTick(uint32_t tick) {
  TickReport report;
  report.tick = tick;
  return report;
}

TickReport with(uint32_t tick, SoundEvent event, uint32_t count = 1, Side side = Side::middle) {
  TickReport report = quietTick(tick);
  report.sounds[uint32_t(event)][uint32_t(side)] = uint16_t(count);
  return report;
}

TickReport kills(uint32_t tick, uint32_t type, uint32_t count, Side side = Side::middle) {
  TickReport report = quietTick(tick);
  report.killSounds[type][uint32_t(side)] = uint16_t(count);
  return report;
}

// Everything at once, on every side.
TickReport pandemonium(uint32_t tick, uint32_t count = 500) {
  TickReport report = quietTick(tick);
  for (auto& sides : report.sounds) std::fill(std::begin(sides), std::end(sides), uint16_t(count));
  for (auto& sides : report.killSounds) std::fill(std::begin(sides), std::end(sides), uint16_t(count));
  return report;
}

float headroomOf(Bus bus) {
  return bus == Bus::work ? kWorkHeadroom : kAlarmHeadroom;
}

TEST(Voices, StartNothingWithoutEvents) {
  Voices voices;
  EXPECT_TRUE(voices.hear(quietTick(1), gameRules()).empty());
}

TEST(Voices, StartEachEventOnceOnItsSide) {
  const std::pair<SoundEvent, Sound> events[] = {
      {SoundEvent::shot, Sound::shot}, {SoundEvent::contact, Sound::contact}, {SoundEvent::bit, Sound::bit},
      {SoundEvent::wave, Sound::wave}, {SoundEvent::flush, Sound::flush},     {SoundEvent::over, Sound::over}};
  for (const auto& [event, sound] : events) {
    for (const Side side : {Side::left, Side::middle, Side::right}) {
      Voices voices;
      const auto starts = voices.hear(with(1, event, 1, side), gameRules());
      ASSERT_EQ(starts.size(), 1u);
      EXPECT_EQ(starts[0].sound, sound);
      EXPECT_EQ(starts[0].side, side);
      EXPECT_GT(starts[0].gain, 0);
    }
  }
}

TEST(Voices, HeavyTypesHaveAKillOfTheirOwn) {
  const Rules& rules = gameRules();
  std::set<Sound> met;
  for (uint32_t type = 0; type < rules.enemyTypeCount; ++type) {
    Voices voices;
    const auto starts = voices.hear(kills(1, type, 1), rules);
    ASSERT_EQ(starts.size(), 1u);
    EXPECT_EQ(starts[0].sound, rules.enemies[type].energy > 4 ? Sound::killHeavy : Sound::kill);
    EXPECT_EQ(starts[0].pitch, killPitch(rules, type));
    met.insert(starts[0].sound);
  }
  EXPECT_EQ(met.size(), 2u);
}

TEST(Voices, ManyKillsAreOneLouderStart) {
  Voices one, many;
  const auto few = one.hear(kills(1, 0, 1), gameRules());
  const auto lots = many.hear(kills(1, 0, 8), gameRules());
  ASSERT_EQ(few.size(), 1u);
  ASSERT_EQ(lots.size(), 1u);
  EXPECT_GT(lots[0].gain, few[0].gain * 0.9f);
  EXPECT_LE(lots[0].gain, kWorkHeadroom / 2);
}

TEST(Voices, LoudnessGrowsWithTheLogarithm) {
  EXPECT_EQ(loudnessOf(0), 1);
  EXPECT_EQ(loudnessOf(1), 1);
  EXPECT_FLOAT_EQ(loudnessOf(2), 1.25f);
  EXPECT_FLOAT_EQ(loudnessOf(4), 1.5f);
  EXPECT_FLOAT_EQ(loudnessOf(65535), 2.5f);
  for (uint32_t n = 1; n < 100; ++n) EXPECT_LE(loudnessOf(n), loudnessOf(n + 1));
}

TEST(Voices, EventsWithinTheSpacingJoinTheNextStart) {
  Voices voices;
  const uint32_t spacing = traitsOf(Sound::shot).spacing_ticks;
  EXPECT_EQ(voices.hear(with(1, SoundEvent::shot), gameRules()).size(), 1u);
  for (uint32_t tick = 2; tick <= spacing; ++tick) {
    EXPECT_TRUE(voices.hear(with(tick, SoundEvent::shot), gameRules()).empty()) << tick;
  }
  const auto joined = voices.hear(quietTick(spacing + 1), gameRules());
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].sound, Sound::shot);
  EXPECT_FLOAT_EQ(joined[0].gain, traitsOf(Sound::shot).gain * loudnessOf(spacing - 1));
}

TEST(Voices, EveryShotOfTheFastestLevelIsHeard) {
  Voices voices;
  uint32_t heard = 0;
  for (uint32_t tick = 1; tick <= 240; ++tick) {
    const auto& starts = voices.hear(tick % 4 == 0 ? with(tick, SoundEvent::shot) : quietTick(tick), gameRules());
    heard += uint32_t(starts.size());
    for (const VoiceStart& start : starts) voices.ended(start.voice);
  }
  EXPECT_EQ(heard, 60u);
}

TEST(Voices, AHordeStartsFewKillsATickButLeavesNoneOut) {
  Voices voices;
  std::set<std::pair<float, Side>> heard;
  for (uint32_t tick = 1; tick <= 12; ++tick) {
    TickReport report = tick == 1 ? pandemonium(tick) : quietTick(tick);
    for (auto& sides : report.sounds) std::fill(std::begin(sides), std::end(sides), uint16_t(0));
    const auto& starts = voices.hear(report, gameRules());
    EXPECT_LE(starts.size(), Voices::kMostKillStarts);
    for (const VoiceStart& start : starts) heard.insert({start.pitch, start.side});
  }
  EXPECT_EQ(heard.size(), size_t(gameRules().enemyTypeCount) * kPans);
}

TEST(Voices, TheOldestWorkIsStolenFirst) {
  Voices voices;
  std::vector<uint32_t> order;
  for (uint32_t tick = 1; order.size() < Voices::kVoices; tick += 100) {
    for (const VoiceStart& start : voices.hear(with(tick, SoundEvent::shot), gameRules())) order.push_back(start.voice);
    for (uint32_t rest = 1; rest < 10; ++rest) voices.hear(quietTick(tick + rest), gameRules());
  }
  EXPECT_EQ(std::set<uint32_t>(order.begin(), order.end()).size(), Voices::kVoices);
  const auto first = voices.hear(with(99999, SoundEvent::shot), gameRules());
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].voice, order[0]);
  const auto second = voices.hear(with(100000, SoundEvent::contact), gameRules());
  ASSERT_EQ(second.size(), 1u);
  EXPECT_EQ(second[0].voice, order[1]);
}

TEST(Voices, WorkNeverCutsAnAlarmOff) {
  Voices voices;
  const auto alarms = voices.hear(with(1, SoundEvent::contact), gameRules());
  ASSERT_EQ(alarms.size(), 1u);
  const uint32_t alarm = alarms[0].voice;
  for (uint32_t tick = 2; tick < 300; ++tick) {
    TickReport report = pandemonium(tick);
    for (const SoundEvent event : {SoundEvent::contact, SoundEvent::wave, SoundEvent::flush, SoundEvent::over}) {
      std::fill(std::begin(report.sounds[uint32_t(event)]), std::end(report.sounds[uint32_t(event)]), uint16_t(0));
    }
    for (const VoiceStart& start : voices.hear(report, gameRules())) EXPECT_NE(start.voice, alarm);
  }
}

TEST(Voices, AContactIsAsLoudInAHordeAsAlone) {
  Voices alone, crowded;
  const float expected = alone.hear(with(1, SoundEvent::contact), gameRules())[0].gain;
  for (uint32_t tick = 1; tick < 120; ++tick) {
    TickReport report = quietTick(tick);
    for (auto& sides : report.killSounds) std::fill(std::begin(sides), std::end(sides), uint16_t(500));
    crowded.hear(report, gameRules());
  }
  TickReport report = pandemonium(120);
  report.sounds[uint32_t(SoundEvent::over)][0] = report.sounds[uint32_t(SoundEvent::over)][1] = 0;
  for (auto& sides : report.sounds) sides[0] = sides[1] = sides[2] = 0;
  report.sounds[uint32_t(SoundEvent::contact)][1] = 1;
  const auto& starts = crowded.hear(report, gameRules());
  ASSERT_FALSE(starts.empty());
  EXPECT_EQ(starts[0].sound, Sound::contact);
  EXPECT_EQ(starts[0].gain, expected);
}

TEST(Voices, BitsInARowClimbAndStartAgain) {
  Voices voices;
  float last = 0;
  uint32_t tick = 1;
  for (uint32_t k = 0; k < 24; ++k, tick += 6) {
    const auto starts = voices.hear(with(tick, SoundEvent::bit), gameRules());
    for (uint32_t rest = 1; rest < 6; ++rest) voices.hear(quietTick(tick + rest), gameRules());
    ASSERT_EQ(starts.size(), 1u);
    EXPECT_GE(starts[0].pitch, last);
    last = starts[0].pitch;
  }
  EXPECT_FLOAT_EQ(last, 2);
  EXPECT_EQ(voices.hear(with(tick + 100, SoundEvent::bit), gameRules())[0].pitch, 1);
}

TEST(Voices, FadingSoundsGiveTheirHeadRoomBack) {
  Voices::Peaks peaks;
  peaks[uint32_t(Sound::kill)] = {0.8f, 0.4f, 0.1f};
  Voices voices(peaks);
  const auto starts = voices.hear(kills(1, 0, 1), gameRules());
  ASSERT_EQ(starts.size(), 1u);
  const float gain = starts[0].gain;
  EXPECT_FLOAT_EQ(voices.used(Bus::work), gain * 0.8f);
  voices.reached(starts[0].voice, 1.5f / 60);
  EXPECT_FLOAT_EQ(voices.used(Bus::work), gain * 0.4f);
  voices.reached(starts[0].voice, 0);  // a position that jumps back takes nothing back
  EXPECT_FLOAT_EQ(voices.used(Bus::work), gain * 0.4f);
  voices.reached(starts[0].voice, 99);
  EXPECT_FLOAT_EQ(voices.used(Bus::work), gain * 0.1f);
  voices.ended(starts[0].voice);
  EXPECT_EQ(voices.used(Bus::work), 0);
}

// OpenAL fades it out while what took its voice already plays.
TEST(Voices, WhatIsCutOffKeepsItsHeadRoomForAMoment) {
  Voices voices;
  uint32_t tick = 1;
  for (uint32_t started = 0; started < Voices::kVoices; tick += 10) {
    started += uint32_t(voices.hear(with(tick, SoundEvent::shot), gameRules()).size());
    for (uint32_t rest = 1; rest < 10; ++rest) voices.hear(quietTick(tick + rest), gameRules());
  }
  const float before = voices.used(Bus::work);
  const auto cutting = voices.hear(with(tick, SoundEvent::contact), gameRules());
  ASSERT_EQ(cutting.size(), 1u);
  for (uint32_t passed = 1; passed < Voices::kCutOff_ticks; ++passed) {
    EXPECT_FLOAT_EQ(voices.used(Bus::work), before) << passed;
    voices.hear(quietTick(tick + passed), gameRules());
  }
  EXPECT_FLOAT_EQ(voices.used(Bus::work), before);
  voices.hear(quietTick(tick + Voices::kCutOff_ticks), gameRules());
  EXPECT_LT(voices.used(Bus::work), before * 0.9f) << "the oldest was the loudest";
}

TEST(KillPitch, FallsWithMassAndDiffersForEveryType) {
  const Rules& rules = gameRules();
  std::map<float, float> massByPitch;
  for (uint32_t type = 0; type < rules.enemyTypeCount; ++type) {
    const float pitch = killPitch(rules, type);
    EXPECT_GE(pitch, 0.4f);
    EXPECT_LE(pitch, 2);
    massByPitch[pitch] = rules.enemies[type].mass;
  }
  ASSERT_EQ(massByPitch.size(), rules.enemyTypeCount);
  float lighter = 1e9f;
  for (const auto& [pitch, mass] : massByPitch) {
    EXPECT_LE(mass, lighter);
    lighter = mass;
  }
}

TEST(KillPitch, TypesAlikeDifferToo) {
  Rules rules = gameRules();
  rules.enemyTypeCount = kMaxEnemyTypes;
  for (EnemyRules& type : rules.enemies) type = rules.enemies[0];
  std::set<float> pitches;
  for (uint32_t type = 0; type < kMaxEnemyTypes; ++type) pitches.insert(killPitch(rules, type));
  EXPECT_EQ(pitches.size(), kMaxEnemyTypes);
  rules.enemyTypeCount = 1;
  EXPECT_GT(killPitch(rules, 0), 1);
}

// Whatever happens: the budget of voices, the head room of both buses, and the spacing of each event hold.
RC_GTEST_PROP(Voices, KeepTheirBudgets, ()) {
  Voices voices;
  std::map<std::pair<Sound, Side>, uint32_t> lastStart;
  const uint32_t ticks = *rc::gen::inRange(1u, 150u);
  for (uint32_t tick = 1; tick <= ticks; ++tick) {
    TickReport report = quietTick(tick);
    const auto count = rc::gen::weightedOneOf<uint16_t>(
        {{3, rc::gen::just(uint16_t(0))}, {2, rc::gen::inRange<uint16_t>(1, 6)}, {1, rc::gen::arbitrary<uint16_t>()}});
    const auto counts = *rc::gen::container<std::vector<uint16_t>>(size_t((kMaxEnemyTypes + 6) * kPans), count);
    for (size_t i = 0; i < counts.size(); ++i) {
      const size_t row = i / kPans, pan = i % kPans;
      (row < kMaxEnemyTypes ? report.killSounds[row] : report.sounds[row - kMaxEnemyTypes])[pan] = counts[i];
    }
    std::set<uint32_t> taken;
    uint32_t killStarts = 0;
    for (const VoiceStart& start : voices.hear(report, gameRules())) {
      RC_ASSERT(start.voice < Voices::kVoices);
      RC_ASSERT(taken.insert(start.voice).second);
      RC_ASSERT(start.gain >= 0 && start.pitch >= 0.4f && start.pitch <= 2.1f);
      const bool kill = start.sound == Sound::kill || start.sound == Sound::killHeavy;
      killStarts += kill;
      if (kill) continue;
      const auto [last, first] = lastStart.try_emplace({start.sound, start.side}, tick);
      RC_ASSERT(first || tick - last->second >= traitsOf(start.sound).spacing_ticks);
      last->second = tick;
    }
    RC_ASSERT(killStarts <= Voices::kMostKillStarts);
    for (const Bus bus : {Bus::work, Bus::alarm}) RC_ASSERT(voices.used(bus) <= headroomOf(bus) * 1.0001f);
    const auto ends = *rc::gen::container<std::vector<uint32_t>>(rc::gen::inRange(0u, Voices::kVoices));
    for (const uint32_t voice : ends) voices.ended(voice);
  }
}

}  // namespace
}  // namespace gw::test
