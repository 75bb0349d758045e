// The sound of the game, from what its reports tell. It never fails: without a device, or without a file, the
// game goes on and one sentence says so.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "game/audio/mixer.h"
#include "game/audio/music.h"
#include "game/settings/settings.h"

namespace gw {

class Audio {
 public:
  using OpenMixer = std::function<std::unique_ptr<Mixer>(const SoundBank&)>;

  // Opens the device at the first update() that is not muted, so a muted game never opens one.
  Audio(const std::filesystem::path& assets, const Settings::Sound& settings, bool muted, OpenMixer open = openMixer,
        Say say = sayOnStderr);
  ~Audio();

  // One tick has passed. Call it once per report.
  void hear(const TickReport& report, const Rules& rules);

  // A frame has passed, which lasted so long. Frees voices, moves the music on, and notices a lost device.
  void update(Scene scene, float passed_s);

  void setVolumes(const Settings::Sound& settings);  // mute is its own switch
  // Unmuting tries a device that was missing or lost once more.
  void setMuted(bool muted);
  bool muted() const { return muted_; }
  // As the player chose in the settings or by key; --mute is not such a choice.
  bool mutedByPlayer() const { return settings_.muted; }

  static void sayOnStderr(const std::string& sentence);

 private:
  void open();
  void startVoices();
  void loseDevice();

  std::filesystem::path folder_;
  Settings::Sound settings_;
  OpenMixer open_;
  Say say_;
  bool muted_;
  bool tried_ = false;  // to open a device since the last unmuting
  std::optional<SoundBank> bank_;
  std::unique_ptr<Mixer> mixer_;
  Voices voices_;
  Stutter stutter_;
  float music_ = 0, effects_ = 1;  // levels, closing in on those of the scene
};

}  // namespace gw
