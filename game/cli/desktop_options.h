// The size of what is drawn, and the window, sound and settings of a person who plays or watches.
#pragma once

#include <cstdint>
#include <filesystem>

namespace gw {

class OptionSet;

struct SizeOptions {
  uint32_t width_px = 1280, height_px = 720;  // of a window or a picture

  void declareSize(OptionSet& options);
};

struct DesktopOptions : SizeOptions {
  bool fullscreen = false;
  bool mute = false;
  std::filesystem::path settingsPath;  // empty: the usual place

  void declareDesktop(OptionSet& options);
};

}  // namespace gw
