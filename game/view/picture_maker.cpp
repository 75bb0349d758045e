#include "game/view/picture_maker.h"

#include <stdexcept>

#include "gpu/devices/device_list.h"
#include "host/platform/user_error.h"
#include "render/gl_context_egl.h"

namespace gw {

PictureMaker::PictureMaker(PixelSize size, const std::filesystem::path& assets, Simulation& simulation) : size_(size) {
  try {
    context_ = makeEglContext(size, simulation.onCuda() ? currentCudaDevice() : std::nullopt);
  } catch (const std::runtime_error& error) {
    throw UserError(ExitCode::failedRun, error.what());
  }
  view_ = std::make_unique<WorldView>(assets, simulation.capacity());
}

PictureMaker::~PictureMaker() {
  view_.reset();
}

Image PictureMaker::draw(Run& run, const Rules& rules, const FollowCamera& camera, float alpha,
                         const WorldView::Screens& screens) {
  context_->bindTarget();
  view_->draw(run, rules, camera, {size_, alpha, 1}, screens);
  Image image = readPixels(size_);
  context_->swap();
  return image;
}

}  // namespace gw
