// What the player hears, through the loopback device: every event, from its side, at its pitch, without clipping.
#include <gtest/gtest.h>

#include <cmath>

#include "game/audio/audio.h"
#include "tests/game/audio/audio_listener.h"

namespace gw::test {
namespace {

// The game's sound, tick by tick, into a listener's ears.
class Game {
 public:
  explicit Game(Settings::Sound settings = {1, 0, false})
      : listener_(gameSounds()),
        audio_(GW_ASSETS_DIR, settings, false, [this](const SoundBank&) { return listener_.takeMixer(); }) {
    audio_.update(Scene::play, 1);
    listener_.listen(0.1);  // volumes settle
  }

  Heard tick(const TickReport& report) {
    audio_.hear(report, gameRules());
    audio_.update(Scene::play, kTick_s);
    return listener_.listen(1.0 / kTicksPerSecond);
  }
  // One tick of it, then silence.
  Heard play(const TickReport& report, double seconds = 0.5) {
    tick(TickReport{});
    audio_.hear(report, gameRules());
    return listener_.listen(seconds);
  }

  Audio& audio() { return audio_; }
  Listener& listener() { return listener_; }

 private:
  Listener listener_;
  Audio audio_;
};

TickReport with(SoundEvent event, Side side = Side::middle) {
  TickReport report;
  report.tick = 1;
  report.sounds[uint32_t(event)][uint32_t(side)] = 1;
  return report;
}

TickReport killOf(uint32_t type, Side side = Side::middle) {
  TickReport report;
  report.tick = 1;
  report.killSounds[type][uint32_t(side)] = 1;
  return report;
}

// All that can be heard, one by one: the events and a light and a heavy kill.
std::vector<TickReport> everySound(Side side = Side::middle) {
  std::vector<TickReport> reports;
  for (uint32_t event = 0; event < uint32_t(SoundEvent::count); ++event)
    reports.push_back(with(SoundEvent(event), side));
  reports.push_back(killOf(0, side));
  reports.push_back(killOf(2, side));
  return reports;
}

// Strength in bands of a third of an octave from 50 Hz, first, soon and later, as a unit vector.
std::vector<double> colourOf(const Heard& heard) {
  std::vector<double> bands;
  double sum = 0;
  for (const auto& [from_s, to_s] : {std::pair(0.0, 0.1), {0.1, 0.3}, {0.3, 0.6}}) {
    const Heard part = heard.between(from_s, to_s);
    for (double low = 50; low < 8000; low *= std::exp2(1.0 / 3)) {
      double power = 0;
      for (int k = 0; k < 4; ++k) power += std::pow(amplitudeAt(part.left, low * std::exp2(k / 12.0)), 2);
      bands.push_back(std::sqrt(power));
      sum += power;
    }
  }
  for (double& band : bands) band /= std::sqrt(sum);
  return bands;
}

TEST(Mix, IsSilentWithoutEvents) {
  EXPECT_EQ(Game().play(TickReport{}).peak(), 0);
}

TEST(Mix, EveryEventIsAudibleAndUnlikeTheOthers) {
  std::vector<std::vector<double>> colours;
  for (const TickReport& report : everySound()) {
    const Heard heard = Game().play(report, 0.6);
    EXPECT_GT(heard.between(0, 0.25).rms(), 0.004) << colours.size();
    colours.push_back(colourOf(heard));
  }
  for (size_t a = 0; a < colours.size(); ++a) {
    for (size_t b = 0; b < a; ++b) {
      double alike = 0;
      for (size_t k = 0; k < colours[a].size(); ++k) alike += colours[a][k] * colours[b][k];
      EXPECT_LT(alike, 0.9) << a << " and " << b;
    }
  }
}

TEST(Mix, ShotsAreTheQuietestAndContactIsLouder) {
  const double shot = Game().play(with(SoundEvent::shot)).rms();
  for (const TickReport& report : everySound()) EXPECT_GE(Game().play(report).rms(), shot * 0.999);
  EXPECT_GT(Game().play(with(SoundEvent::contact)).rms(), 3 * shot);
}

TEST(Mix, ComesFromItsSide) {
  for (const TickReport& report : everySound(Side::left)) {
    const Heard heard = Game().play(report);
    EXPECT_GT(rmsOf(heard.left), 2 * rmsOf(heard.right));
  }
  for (const TickReport& report : everySound(Side::right)) {
    const Heard heard = Game().play(report);
    EXPECT_GT(rmsOf(heard.right), 2 * rmsOf(heard.left));
  }
  for (const TickReport& report : everySound()) {
    const Heard heard = Game().play(report);
    EXPECT_NEAR(rmsOf(heard.left), rmsOf(heard.right), rmsOf(heard.left) * 0.01);
  }
}

TEST(Mix, KillsAreTunedByType) {
  for (uint32_t type = 0; type < gameRules().enemyTypeCount; ++type) {
    const Heard heard = Game().play(killOf(type)).between(0.02, 0.3);
    const double expected = 440 * double(killPitch(gameRules(), type));
    const double found = dominantFrequency(heard.left, 150, 1000);
    EXPECT_NEAR(std::log2(found / expected) * 12, 0, 0.5) << gameRules().enemies[type].name << " " << found;
  }
}

// Everything at once, for seconds, at full volume with the music: no sample reaches the limit, although the float
// output has no limiter.
TEST(Mix, PandemoniumDoesNotClip) {
  for (const bool oneSide : {false, true}) {
    Game game({1, 1, false});
    float peak = 0;
    double loudest = 0;
    for (uint32_t tick = 1; tick <= 240; ++tick) {
      TickReport report;
      report.tick = tick;
      const auto fill = [&](uint16_t(&sides)[kPans]) {
        for (uint32_t pan = 0; pan < kPans; ++pan) sides[pan] = !oneSide || pan == 0 ? 500 : 0;
      };
      for (auto& sides : report.sounds) fill(sides);
      for (auto& sides : report.killSounds) fill(sides);
      const Heard heard = game.tick(report);
      peak = std::max(peak, heard.peak());
      loudest = std::max(loudest, heard.rms());
    }
    EXPECT_LT(peak, 1);
    EXPECT_GT(loudest, 0.1);
  }
}

// A first burst, after silence, in which all voices begin in the same sample.
TEST(Mix, OneBurstDoesNotClip) {
  Game game({1, 1, false});
  TickReport report;
  report.tick = 1;
  for (auto& sides : report.sounds) std::fill(std::begin(sides), std::end(sides), uint16_t(65535));
  for (auto& sides : report.killSounds) std::fill(std::begin(sides), std::end(sides), uint16_t(65535));
  EXPECT_LT(game.play(report, 2).peak(), 1);
}

// Sounds at full scale that never fade, as a user's files may be: the head room holds for these too.
TEST(Mix, SoundsAtFullScaleDoNotClip) {
  SoundBank loud;
  for (Clip& clip : loud.effects) clip = {48000, std::vector<int16_t>(96000, 32767)};
  loud.music = {48000, std::vector<int16_t>(48000, 32767)};
  Listener listener(loud);
  const auto mixer = listener.takeMixer();
  mixer->setMusic(kMusicGain, 1);
  Voices voices;
  for (uint32_t tick = 1; tick <= 120; ++tick) {
    TickReport report;
    report.tick = tick;
    for (auto& sides : report.sounds) sides[1] = 500;  // the ship's own sounds come from the middle, kills also aside
    for (auto& sides : report.killSounds) sides[0] = 500;
    for (const VoiceStart& start : voices.hear(report, gameRules())) mixer->start(start);
    EXPECT_LT(listener.listen(1.0 / 60).peak(), 1) << tick;
  }
}

TEST(Mix, MusicRepeatsWithoutASeam) {
  Listener listener(gameSounds());
  const auto mixer = listener.takeMixer();
  mixer->setMusic(0.5f, 1);
  const double length_s = double(gameSounds().music.samples.size()) / gameSounds().music.rate_hz;
  listener.listen(length_s - 1);
  const std::vector<float> around = listener.listen(2).left;  // the loop point lies in the middle
  listener.listen(length_s - 2);
  const std::vector<float> again = listener.listen(2).left;  // a round later
  EXPECT_GT(rmsOf(around), 0.02);
  // The jump where the end meets the beginning is no larger than those around it.
  const size_t middle = around.size() / 2, near = kListenRate_hz / 200;
  float atSeam = 0, elsewhere = 0;
  for (size_t i = 1; i < around.size(); ++i) {
    const float jump = std::abs(around[i] - around[i - 1]);
    (i + near > middle && i < middle + near ? atSeam : elsewhere) =
        std::max(i + near > middle && i < middle + near ? atSeam : elsewhere, jump);
  }
  EXPECT_LE(atSeam, elsewhere);
  EXPECT_LE(std::abs(around[middle] - around[middle - 1]), 0.01f);
  for (size_t i = 0; i < around.size(); ++i) ASSERT_NEAR(around[i], again[i], 1e-3f) << i;
}

TEST(Mix, MuteIsSilenceAndUnmutingIsNot) {
  Game game({1, 1, false});
  EXPECT_GT(game.tick(with(SoundEvent::contact)).peak(), 0);
  game.audio().setMuted(true);
  game.tick(with(SoundEvent::flush));
  game.listener().listen(0.1);  // gains glide
  EXPECT_EQ(game.listener().listen(1).peak(), 0);
  game.audio().setMuted(false);
  game.tick(TickReport{});
  EXPECT_GT(game.listener().listen(1).rms(), 0.01);
}

TEST(Mix, VolumesScale) {
  const double full = Game({1, 0, false}).play(with(SoundEvent::contact)).rms();
  const double half = Game({0.5f, 0, false}).play(with(SoundEvent::contact)).rms();
  EXPECT_NEAR(half / full, 0.5, 0.005);
  EXPECT_EQ(Game({0, 0, false}).play(with(SoundEvent::contact)).peak(), 0);

  const auto music = [](float volume) {
    Game game({0, volume, false});
    return game.listener().listen(1).rms();
  };
  EXPECT_GT(music(1), 0.01);
  EXPECT_NEAR(music(0.25f) / music(1), 0.25, 0.005);

  Game changed({1, 0, false});
  changed.audio().setVolumes({0.5f, 0, false});
  EXPECT_NEAR(changed.play(with(SoundEvent::contact)).rms() / full, 0.5, 0.005);
}

TEST(Mix, AMissingSoundIsSilence) {
  SoundBank bank = gameSounds();
  bank.effects[uint32_t(Sound::contact)] = {};
  bank.music = {};
  Listener listener(bank);
  const auto mixer = listener.takeMixer();
  mixer->setMusic(1, 1);
  EXPECT_FALSE(mixer->start({0, Sound::contact, Side::middle, 1, 1}));
  EXPECT_EQ(listener.listen(0.5).peak(), 0);
  EXPECT_TRUE(mixer->start({0, Sound::bit, Side::middle, 1, 1}));
  EXPECT_GT(listener.listen(0.5).peak(), 0);
  EXPECT_EQ(mixer->position_s(0), std::nullopt);
}

}  // namespace
}  // namespace gw::test
