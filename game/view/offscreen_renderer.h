// Pictures of a run without a window, for headless screenshots and films.
#pragma once

#include <filesystem>
#include <memory>

#include "game/view/world_renderer.h"
#include "render/screenshot.h"

namespace gw {

class OffscreenRenderer {
 public:
  // Throws UserError when there is no OpenGL without a display, or an asset is missing.
  OffscreenRenderer(PixelSize size, const std::filesystem::path& assets, Simulation& simulation);

  // The run between its last two ticks, with `screens` on top.
  Image draw(Run& run, const Rules& rules, const FollowCamera& camera, float alpha,
             const WorldRenderer::Screens& screens);

  float aspect() const { return float(size_.width) / float(size_.height); }

 private:
  PixelSize size_;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<WorldRenderer> renderer_;  // after the context: its GL objects are deleted first
};

}  // namespace gw
