// The window's loop: events in, ticks when they are due, pictures at the screen's own rate. Play and
// replay are the same loop with another source of input and other screens.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "game/audio/audio.h"
#include "game/camera.h"
#include "game/command_line.h"
#include "game/input/pad_devices.h"
#include "game/input/player_input.h"
#include "game/run.h"
#include "game/settings/settings.h"
#include "game/tick_pacer.h"
#include "game/world_view.h"
#include "render/gl_context_sdl.h"

namespace gw {

struct CanvasPoint {
  float x = 0, y = 0;
};

class GameLoop {
 public:
  // Opens the window. Throws UserError, one sentence, when there is no display or no OpenGL 4.5.
  GameLoop(const Options& options, const Settings& settings);
  ~GameLoop();

  // Loads what drawing and sound need, once, for simulations of this capacity.
  void prepare(const std::filesystem::path& assets, uint32_t capacity);

  // What the player chose anew, from the next frame on.
  void apply(const Settings& settings);
  bool fullscreen() const { return fullscreen_; }
  bool muted() const { return sound_.muted; }  // --mute is not the player's choice

  // Takes the events and the time of a new frame. False when the window was closed.
  bool beginFrame();

  // Runs the ticks that are due. `input` is asked once per tick; a tick that cost the ship time is
  // followed by the hit-stop. Stops at the end of the run, or when `input` returns false.
  using InputSource = std::function<bool(InputRecord&)>;
  void runTicks(Run& run, const Rules& rules, const InputSource& input);

  // What keyboard, mouse and pad say now.
  InputRecord playerInput(const Run& run);
  // What lies under the pointer, and where a place of the world is on a canvas; after the first frame.
  WorldPoint underPointer() const;
  CanvasPoint onCanvas(WorldPoint place) const;

  // Draws the run and the screens over it, shows the picture, and waits where the screen does not.
  void endFrame(Run& run, const Rules& rules, float brightness, const WorldView::Screens& screens);

  // Another run begins: its camera and its clock start afresh.
  void startAfresh(Run& run);
  void showCursor(bool on);
  void drawCrosshair(Canvas& canvas) const;

  // What the frame sounds like; after the screen of this frame is known.
  void updateSound(Scene scene);

  PlayerInput& input() { return input_; }
  Audio& audio() { return *audio_; }
  TickPacer& pacer() { return pacer_; }
  const TickPacer& pacer() const { return pacer_; }
  double now_s() const { return now_s_; }
  double realFps() const { return realFps_; }

 private:
  void mute(bool on);
  void limitFrames();
  void countFrame();

  std::unique_ptr<SdlContext> context_;
  std::unique_ptr<WorldView> view_;
  std::unique_ptr<FollowCamera> camera_;
  std::unique_ptr<Audio> audio_;
  std::unique_ptr<PadDevices> pads_;
  PlayerInput input_;
  TickPacer pacer_;
  Settings::Effects effects_;
  double now_s_ = 0, last_s_ = 0;
  double nextFrame_s_ = 0, period_s_ = 1.0 / 60;
  double countedSince_s_ = 0, realFps_ = 0;
  double overSince_s_ = 0;  // 0: the run is not over
  uint32_t counted_ = 0;
  Settings::Sound sound_;  // as the player chose, in the settings or by key
  bool mute_ = false;      // --mute: holds until the player chooses
  bool fullscreen_ = false, cursorShown_ = true, closed_ = false;
};

}  // namespace gw
