// What the game uses: no device, a lost one, mute, and what a report turns into.
#include <gtest/gtest.h>

#include "game/audio/audio.h"
#include "tests/game/audio/audio_listener.h"

namespace gw::test {
namespace {

// A device made of counters.
struct Desk {
  uint32_t opened = 0, alive = 0;
  bool present = true, connected = true;
  std::vector<VoiceStart> started;
  bool playsOn = false;  // voices never end
  float effects = -1, music = -1;
  std::vector<std::string> said;
};

class DeskMixer : public Mixer {
 public:
  explicit DeskMixer(Desk& desk) : desk_(desk) { ++desk_.alive; }
  ~DeskMixer() override { --desk_.alive; }
  bool start(const VoiceStart& start) override {
    desk_.started.push_back(start);
    return true;
  }
  std::optional<float> position_s(uint32_t) const override {
    return desk_.playsOn ? std::optional<float>(0.0f) : std::nullopt;
  }
  void setEffects(float gain) override { desk_.effects = gain; }
  void setMusic(float gain, float) override { desk_.music = gain; }
  bool connected() const override { return desk_.connected; }

 private:
  Desk& desk_;
};

Audio audioAt(Desk& desk, bool muted = false, Settings::Sound settings = {1, 1, false}) {
  return Audio(
      GW_ASSETS_DIR, settings, muted,
      [&desk](const SoundBank&) -> std::unique_ptr<Mixer> {
        ++desk.opened;
        if (!desk.present) return nullptr;
        desk.connected = true;
        return std::make_unique<DeskMixer>(desk);
      },
      [&desk](const std::string& sentence) { desk.said.push_back(sentence); });
}

TickReport contact(uint32_t tick) {
  TickReport report;
  report.tick = tick;
  report.sounds[uint32_t(SoundEvent::contact)][1] = 1;
  return report;
}

void frames(Audio& audio, uint32_t count, Scene scene = Scene::play) {
  for (uint32_t f = 0; f < count; ++f) audio.update(scene, 1.0f / 60);
}

TEST(Audio, WithoutADeviceSaysSoOnceAndGoesOn) {
  Desk desk;
  desk.present = false;
  Audio audio = audioAt(desk);
  for (uint32_t tick = 1; tick < 100; ++tick) {
    audio.hear(contact(tick), gameRules());
    frames(audio, 1);
  }
  EXPECT_EQ(desk.opened, 1u);
  ASSERT_EQ(desk.said.size(), 1u);
  EXPECT_NE(desk.said[0].find("no sound device"), std::string::npos);
  EXPECT_EQ(desk.said[0].find('\n'), std::string::npos);
}

TEST(Audio, MutedOpensNoDeviceUntilItIsUnmuted) {
  Desk desk;
  Audio audio = audioAt(desk, true);
  frames(audio, 10);
  audio.hear(contact(1), gameRules());
  EXPECT_EQ(desk.opened, 0u);
  EXPECT_TRUE(audio.muted());
  audio.setMuted(false);
  frames(audio, 1);
  EXPECT_EQ(desk.opened, 1u);
  audio.hear(contact(2), gameRules());
  EXPECT_EQ(desk.started.size(), 1u);
  audio.setMuted(true);
  audio.setMuted(false);
  frames(audio, 1);
  EXPECT_EQ(desk.opened, 1u);
  EXPECT_TRUE(desk.said.empty());
}

TEST(Audio, TheSettingMutesToo) {
  Desk desk;
  Audio audio = audioAt(desk, false, {1, 1, true});
  frames(audio, 3);
  EXPECT_EQ(desk.opened, 0u);
}

TEST(Audio, UnmutingTriesAMissingDeviceAgain) {
  Desk desk;
  desk.present = false;
  Audio audio = audioAt(desk);
  frames(audio, 3);
  desk.present = true;
  frames(audio, 3);
  EXPECT_EQ(desk.opened, 1u);
  audio.setMuted(true);
  audio.setMuted(false);
  frames(audio, 3);
  EXPECT_EQ(desk.opened, 2u);
  EXPECT_EQ(desk.alive, 1u);
}

TEST(Audio, ALostDeviceIsReplacedSilently) {
  Desk desk;
  Audio audio = audioAt(desk);
  frames(audio, 3);
  desk.connected = false;
  frames(audio, 3);
  EXPECT_EQ(desk.opened, 2u);
  EXPECT_EQ(desk.alive, 1u);
  EXPECT_TRUE(desk.said.empty());
  audio.hear(contact(1), gameRules());
  EXPECT_EQ(desk.started.size(), 1u);
}

TEST(Audio, ALostDeviceWithoutAnotherIsOneSentence) {
  Desk desk;
  Audio audio = audioAt(desk);
  frames(audio, 3);
  desk.connected = desk.present = false;
  for (uint32_t tick = 1; tick < 50; ++tick) {
    frames(audio, 1);
    audio.hear(contact(tick), gameRules());
  }
  EXPECT_EQ(desk.opened, 2u);
  EXPECT_EQ(desk.alive, 0u);
  ASSERT_EQ(desk.said.size(), 1u);
  EXPECT_NE(desk.said[0].find("gone"), std::string::npos);
  desk.present = true;
  audio.setMuted(true);
  audio.setMuted(false);
  frames(audio, 1);
  EXPECT_EQ(desk.alive, 1u);
}

TEST(Audio, LosingTheDeviceWhileMutedOpensItOnUnmuting) {
  Desk desk;
  Audio audio = audioAt(desk);
  frames(audio, 1);
  audio.setMuted(true);
  desk.connected = false;
  frames(audio, 5);
  EXPECT_EQ(desk.opened, 1u);
  audio.setMuted(false);
  frames(audio, 1);
  EXPECT_EQ(desk.opened, 2u);
  EXPECT_EQ(desk.alive, 1u);
}

TEST(Audio, StartsNothingWhileMuted) {
  Desk desk;
  Audio audio = audioAt(desk);
  frames(audio, 30);
  audio.setMuted(true);
  frames(audio, 1);
  audio.hear(contact(1), gameRules());
  EXPECT_TRUE(desk.started.empty());
  EXPECT_EQ(desk.effects, 0);
  EXPECT_EQ(desk.music, 0);
}

TEST(Audio, FadesBetweenScreens) {
  Desk desk;
  Audio audio = audioAt(desk);
  frames(audio, 60, Scene::play);
  EXPECT_FLOAT_EQ(desk.music, kMusicGain);
  EXPECT_FLOAT_EQ(desk.effects, 1);
  frames(audio, 1, Scene::pause);
  EXPECT_LT(desk.music, kMusicGain);
  EXPECT_GT(desk.music, kMusicGain * musicLevel(Scene::pause));
  frames(audio, 60, Scene::pause);
  EXPECT_FLOAT_EQ(desk.music, kMusicGain * musicLevel(Scene::pause));
  frames(audio, 60, Scene::title);
  EXPECT_FLOAT_EQ(desk.effects, effectsLevel(Scene::title));
  frames(audio, 60, Scene::over);
  EXPECT_FLOAT_EQ(desk.music, kMusicGain * musicLevel(Scene::over));
}

TEST(Audio, TheMusicStuttersInPlayOnly) {
  Desk desk;
  Audio audio = audioAt(desk);
  frames(audio, 60);
  TickReport report;
  report.frameTime_us = gameRules().budget.limit_us;
  report.tick = 16 * 100;  // a gap begins
  audio.hear(report, gameRules());
  frames(audio, 1);
  EXPECT_LT(desk.music, 0.5f * kMusicGain);
  frames(audio, 60, Scene::pause);
  EXPECT_FLOAT_EQ(desk.music, kMusicGain * musicLevel(Scene::pause));
}

TEST(Audio, VoicesThatEndedAreFree) {
  Desk desk;
  Audio audio = audioAt(desk);
  frames(audio, 1);
  for (uint32_t tick = 1; tick <= 40 * 20; ++tick) {
    audio.hear(tick % 20 == 0 ? contact(tick) : TickReport{}, gameRules());
    frames(audio, 1);
  }
  ASSERT_EQ(desk.started.size(), 40u);
  for (const VoiceStart& start : desk.started) {
    EXPECT_EQ(start.voice, 0u);
    EXPECT_EQ(start.gain, desk.started[0].gain);
  }
}

TEST(Audio, VoicesThatPlayOnAreNotTaken) {
  Desk desk;
  desk.playsOn = true;
  Audio audio = audioAt(desk);
  frames(audio, 1);
  for (uint32_t tick = 1; tick <= 60; ++tick) {
    audio.hear(tick % 20 == 0 ? contact(tick) : TickReport{}, gameRules());
    frames(audio, 1);
  }
  ASSERT_EQ(desk.started.size(), 3u);
  EXPECT_EQ(desk.started[1].voice, 1u);
  EXPECT_EQ(desk.started[2].voice, 2u);
  EXPECT_LT(desk.started[1].gain, desk.started[0].gain);  // the head room is shared
}

}  // namespace
}  // namespace gw::test
