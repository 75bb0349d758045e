// Where the frames of a session are drawn, and what that costs: a window without vertical sync, or a frame buffer
// without a window.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "game/view/world_renderer.h"
#include "render/gl_objects.h"

namespace gw::profile {

// An OpenGL context, and what takes the events of its window.
struct Screen {
  std::unique_ptr<GlContext> context;
  std::function<bool()> open;  // takes events; false: it was closed, or Escape was pressed. May be empty
  std::string about;           // "window", "offscreen"
};

// Throws UserError, one sentence. The window needs a build with one.
Screen openOffscreen(PixelSize size, bool onCuda);
Screen openWindow(PixelSize size);

struct Look {
  bool effects = true;      // particles, flashes, bending, shake
  float glow = 0.5f;        // Settings::Effects::glow
  bool wholeWorld = false;  // else the view of a player
};

struct PictureCost {
  double draw_ms = 0, wait_ms = 0;
  bool timed = false;  // OpenGL will tell of it
};

class Picture {
 public:
  // `screen` must outlive this.
  Picture(Screen& screen, const std::filesystem::path& assets, const Look& look);

  bool showsEffects() const { return look_.effects; }

  // Another run begins.
  void begin(Run& run);

  // One frame, `alpha` of the way between its last two ticks, `passed_s` after the one before. `title`: the title is
  // over it. `timed`: by OpenGL too.
  PictureCost draw(Run& run, const Rules& rules, float alpha, float passed_s, bool title, bool timed);

  // The time that OpenGL took for a timed frame, some frames later; nothing when none is ready. In the order of frames.
  std::optional<double> takeGlTime_ms(bool wait);

 private:
  void follow(Run& run, float alpha, float passed_s);

  static constexpr size_t kQueries = 4;  // frames on their way
  Screen& screen_;
  WorldRenderer renderer_;
  Look look_;
  std::optional<FollowCamera> camera_;
  std::array<GlQuery, kQueries> queries_;
  uint64_t asked_ = 0, answered_ = 0;
};

}  // namespace gw::profile
