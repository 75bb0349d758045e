// What every session with a window works with. Made once, in this order, and passed on by reference.
#pragma once

#include <filesystem>

#include "game/app/frame_clock.h"
#include "game/app/game_window.h"
#include "game/app/run_view.h"
#include "game/audio/audio.h"
#include "game/cli/desktop_options.h"
#include "game/input/player_input.h"
#include "game/overlay/instruments.h"
#include "game/session/fixed_timestep.h"
#include "game/settings/settings.h"
#include "host/input/pad_devices.h"

namespace gw {

struct AppServices {
  // Throws UserError when the window cannot be opened, or an asset is missing or damaged.
  AppServices(const DesktopOptions& options, const Settings& settings, const std::filesystem::path& assets);
  AppServices(const AppServices&) = delete;
  AppServices& operator=(const AppServices&) = delete;

  // Settings that the player has changed, effective from the next frame.
  void apply(const Settings& settings);
  // Another run begins.
  void beginRun(Run& run);
  // The point of the world under the pointer, in the last picture.
  WorldPoint pointerInWorld() const;

  GameWindow window;
  Instruments instruments;
  PadDevices pads;
  PlayerInput input;
  FrameClock clock;
  FixedTimestep timestep;
  RunView view;
  Audio audio;
};

}  // namespace gw
