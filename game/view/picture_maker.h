// Pictures of a run without a window: what headless screenshots and films are made with.
#pragma once

#include <filesystem>
#include <memory>

#include "game/view/world_view.h"
#include "render/screenshot.h"

namespace gw {

class PictureMaker {
 public:
  // Throws UserError when there is no OpenGL without a display, or an asset is missing.
  PictureMaker(PixelSize size, const std::filesystem::path& assets, Simulation& simulation);
  ~PictureMaker();

  // The run between its last two ticks, with what `screens` put over it.
  Image draw(Run& run, const Rules& rules, const FollowCamera& camera, float alpha, const WorldView::Screens& screens);

  float aspect() const { return float(size_.width) / float(size_.height); }

 private:
  PixelSize size_;
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<WorldView> view_;  // its GL objects go before their context
};

}  // namespace gw
