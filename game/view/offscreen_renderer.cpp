#include "game/view/offscreen_renderer.h"

#include <stdexcept>

#include "gpu/devices/device_list.h"
#include "host/platform/user_error.h"
#include "render/gl_context_egl.h"

namespace gw {

OffscreenRenderer::OffscreenRenderer(PixelSize size, const std::filesystem::path& assets, Simulation& simulation)
    : size_(size) {
  try {
    context_ = makeEglContext(size, simulation.onCuda() ? currentCudaDevice() : std::nullopt);
  } catch (const std::runtime_error& error) {
    throw UserError(ExitCode::failedRun, error.what());
  }
  renderer_ = std::make_unique<WorldRenderer>(assets);
}

Image OffscreenRenderer::draw(Run& run, const Rules& rules, const FollowCamera& camera, float alpha,
                              const WorldRenderer::Screens& screens) {
  context_->bindTarget();
  renderer_->draw(run, rules, camera, {size_, alpha, 1}, screens);
  Image image = readPixels(size_);
  context_->swap();
  return image;
}

}  // namespace gw
