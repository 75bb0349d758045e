// The picture of a run: the renderer, and a camera that follows the ship or stays where it was placed.
#pragma once

#include <filesystem>
#include <optional>

#include "game/app/frame_clock.h"
#include "game/app/game_window.h"
#include "game/input/keyboard_mouse.h"
#include "game/session/fixed_timestep.h"
#include "game/view/world_renderer.h"

namespace gw {

struct RunViewFrame {
  PixelSize target;
  float brightness = 1;  // of the world; less behind menus
  Colouring colouring = Colouring::types;
};

class RunView {
 public:
  // Needs the window's context. Throws UserError when an asset is missing or damaged.
  RunView(const std::filesystem::path& assets, const Settings::Effects& effects);

  void setEffects(const Settings::Effects& effects) { effects_ = effects; }

  // Another run begins: its world may have another size.
  void begin(Simulation& simulation);

  // Fixes the camera there; none: it follows the ship.
  void placeCamera(const std::optional<CameraPlace>& place) { place_ = place; }
  CameraPlace cameraPlace() const;
  // The next picture is of another tick: the camera cuts there instead of moving.
  void cutCamera() { cut_ = true; }

  // Between the window and the world, as the last picture had it.
  WorldPoint toWorld(float x_px, float y_px, const EventArea& area) const;
  CanvasPoint toCanvas(WorldPoint place, float canvasWidth) const;

  void draw(Run& run, const Rules& rules, const FrameClock& clock, const FixedTimestep& timestep,
            const RunViewFrame& view, const WorldRenderer::Screens& screens);

 private:
  void moveCamera(Run& run, const FrameClock& clock, const FixedTimestep& timestep, float aspect);

  WorldRenderer renderer_;
  std::optional<FollowCamera> camera_;  // none before the first run
  Settings::Effects effects_;
  std::optional<CameraPlace> place_;
  bool cut_ = false;
  double drawn_s_ = 0;      // the last picture's time; 0: none yet
  double overSince_s_ = 0;  // 0: the run is not over
};

}  // namespace gw
