// The window's loop: events in, ticks when they are due, pictures at the screen's own rate. Play and
// replay are the same loop with another source of input and other screens.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "game/app/fullscreen_switch.h"
#include "game/audio/audio.h"
#include "game/cli/command_line.h"
#include "game/input/player_input.h"
#include "game/overlay/instruments.h"
#include "game/session/frame_limiter.h"
#include "game/session/run.h"
#include "game/session/tick_pacer.h"
#include "game/settings/settings.h"
#include "game/view/camera.h"
#include "game/view/world_view.h"
#include "host/input/pad_devices.h"
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
  bool fullscreen() const { return fullscreen_.on(); }
  bool muted() const { return sound_.muted; }  // --mute is not the player's choice

  // How F5 makes another simulation of the run (Instruments).
  void makeBy(MakeSimulation make) { instruments_->makeBy(std::move(make)); }

  // Is shown every event but those of the instruments before keyboard, mouse and pads are; true: it goes no further.
  using Listener = std::function<bool(const SDL_Event&)>;
  void listenFirst(Listener listener) { listener_ = std::move(listener); }

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

  // Of a point of the window, as events have it.
  CanvasPoint toCanvas(float x_px, float y_px) const;
  float canvasWidth() const;

  // The camera looks there from now on; none: it follows the ship.
  void look(const std::optional<CameraPlace>& place) { place_ = place; }
  CameraPlace cameraPlace() const;
  // The next picture is of another moment: the camera does not fly there.
  void jump() { jumped_ = true; }

  // Draws the run and the screens over it, shows the picture, and waits where the screen does not. Of a hidden window
  // nothing is drawn.
  void endFrame(Run& run, const Rules& rules, float brightness, const WorldView::Screens& screens);

  // Another run begins: its camera and its clock start afresh.
  void startAfresh(Run& run);
  void showCursor(bool on);
  // Keeps the pointer in the window while it has the focus.
  void keepPointer(bool on);
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
  void moveCamera(const Run& run, float alpha, float aspect);
  void draw(Run& run, const Rules& rules, float brightness, const WorldView::Screens& screens);
  void switchFullscreen(bool on);
  void limitFrames(bool hidden);
  void countFrame();

  std::unique_ptr<SdlContext> context_;
  std::unique_ptr<Instruments> instruments_;
  std::unique_ptr<WorldView> view_;
  std::unique_ptr<FollowCamera> camera_;
  std::unique_ptr<Audio> audio_;
  std::unique_ptr<PadDevices> pads_;
  PlayerInput input_;
  TickPacer pacer_;
  Settings::Effects effects_;
  Listener listener_;
  std::vector<SDL_Event> events_;  // of this frame
  std::optional<CameraPlace> place_;
  bool jumped_ = false;
  double now_s_ = 0, last_s_ = 0;
  double drawn_s_ = 0;  // the last picture's time
  FrameLimiter limiter_;
  double countedSince_s_ = 0, realFps_ = 0;
  double overSince_s_ = 0;  // 0: the run is not over
  uint32_t counted_ = 0;
  Settings::Sound sound_;  // as the player chose, in the settings or by key
  bool mute_ = false;      // --mute: holds until the player chooses
  FullscreenSwitch fullscreen_;
  bool cursorShown_ = true, pointerKept_ = false, closed_ = false;
};

}  // namespace gw
