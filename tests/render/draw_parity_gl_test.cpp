// The same games drawn from both devices, pixel for pixel: the draw list, the particles and their way to OpenGL. With
// GW_SCREENSHOTS=FOLDER the last pair of pictures of each game is left there.
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "game/tables/tables.h"
#include "game/ui/hud.h"
#include "game/view/world_renderer.h"
#include "render/screenshot.h"
#include "tests/render/cuda_gl_fixture.h"
#include "tests/render/image_compare.h"

namespace gw {
namespace {

using GameRun = Run;  // within a test, Run is the test framework's

// A frame every so many ticks, more than the ring of buffers has regions.
constexpr uint32_t kTicks = 420, kFrameEvery_ticks = 60;

std::unique_ptr<Simulation> makeOnCuda([[maybe_unused]] const SimulationConfig& config) {
#ifdef GW_HAVE_CUDA
  return cuda::makeSimulation(config);
#else
  throw std::logic_error("This build has no cuda device.");  // the fixture has skipped the test before
#endif
}

class DrawParity : public CudaGlTest, public testing::WithParamInterface<Mode> {
 protected:
  void SetUp() override {
    CudaGlTest::SetUp();
    if (IsSkipped()) return;
    config_.rules = loadRules(readRuleTexts(kAssets));
    config_.seed = 7;
    config_.mode = GetParam();
    config_.enemies = 2048;
    config_.autopilot = Autopilot::expert;
    config_.particles = true;
  }

  static FollowCamera cameraOf(GameRun& run, float alpha) {
    FollowCamera camera(run.simulation().worldWidth_m(), run.simulation().worldHeight_m());
    camera.snap(cameraTarget(run.last(), alpha), float(kSize.width) / float(kSize.height));
    return camera;
  }

  // Without a GPU fewer are drawn: a picture with more than that must differ.
  bool particlesFit(GameRun& onCpu, float alpha) {
    const Camera camera = cameraOf(onCpu, alpha).view();
    std::vector<ParticleVertex> vertices(WorldRenderer::kParticlesDrawn);
    DrawArraysCommand command = ParticleStream::kDrawNothing;
    onCpu.simulation().particleList({camera.centre_x, camera.centre_y, 2 * camera.halfWidth_m, 2 * camera.halfHeight_m},
                                    alpha, {vertices.data(), uint32_t(vertices.size()), &command});
    return command.instanceCount <= WorldRenderer::kParticlesDrawnWithoutGpu;
  }

  Image draw(WorldRenderer& view, GameRun& run, float alpha) {
    const FollowCamera camera = cameraOf(run, alpha);
    context_->bindTarget();
    WorldFrame frame{kSize};
    frame.alpha = alpha;
    frame.effects.particles = particles_;
    view.draw(run, config_.rules, camera, frame, [&](Canvas& canvas) {
      HudFrame hud;
      hud.mode = config_.mode;
      hud.enemies = config_.enemies;
      drawHud(canvas, run.monitor(), config_.rules, hud);
    });
    return readPixels(kSize);
  }

  void keep(const Image& image, const char* device) const {
    const char* folder = std::getenv("GW_SCREENSHOTS");
    if (folder == nullptr || *folder == '\0') return;
    std::filesystem::create_directories(folder);
    const std::string mode = config_.mode == Mode::arcade ? "arcade" : "swarm";
    writePng(std::filesystem::path(folder) / (mode + "_" + device + ".png"), image);
  }

  SimulationConfig config_;
  bool particles_ = true;
};

TEST_P(DrawParity, EveryPictureIsTheSame) {
  GameRun onCpu(cpu::makeSimulation(config_), std::nullopt), onCuda(makeOnCuda(config_), std::nullopt);
  WorldRenderer cpuView(kAssets);
  WorldRenderer cudaView(kAssets);
  std::vector<uint8_t> before;
  uint32_t withParticles = 0;
  for (uint32_t tick = 1; tick <= kTicks; ++tick) {
    onCpu.tick({});
    onCuda.tick({});
    ASSERT_EQ(onCpu.last().hash, onCuda.last().hash) << "tick " << tick;
    if (tick % kFrameEvery_ticks != 0) continue;
    const float alpha = float(tick / kFrameEvery_ticks % 4) / 3;
    particles_ = particlesFit(onCpu, alpha);
    withParticles += particles_;
    const Image expected = draw(cpuView, onCpu, alpha), actual = draw(cudaView, onCuda, alpha);
    EXPECT_EQ(expected.rgb, actual.rgb) << "tick " << tick;
    EXPECT_NE(expected.rgb, before) << "tick " << tick;  // pictures of a game that goes on
    before = expected.rgb;
    if (tick + kFrameEvery_ticks <= kTicks) continue;
    keep(expected, "cpu");
    keep(actual, "cuda");
  }
  EXPECT_GT(onCpu.last().kills, 10u) << "too little happened to compare";
  EXPECT_GT(onCpu.simulation().particles().size(), 10u) << "too little happened to compare";
  EXPECT_GT(withParticles, kTicks / kFrameEvery_ticks / 2);
}

// What a game does when CUDA fails in the middle of it.
TEST_P(DrawParity, AViewGoesOnFromTheOtherDevice) {
  GameRun onCpu(cpu::makeSimulation(config_), std::nullopt), onCuda(makeOnCuda(config_), std::nullopt);
  for (uint32_t tick = 0; tick < 2 * kFrameEvery_ticks; ++tick) {
    onCpu.tick({});
    onCuda.tick({});
  }
  WorldRenderer view(kAssets);
  const Image fromCuda = draw(view, onCuda, 1);
  EXPECT_EQ(draw(view, onCpu, 1).rgb, fromCuda.rgb);
  EXPECT_EQ(draw(view, onCuda, 1).rgb, fromCuda.rgb);
}

INSTANTIATE_TEST_SUITE_P(Modes, DrawParity, testing::Values(Mode::arcade, Mode::swarm),
                         [](const auto& info) { return info.param == Mode::arcade ? "arcade" : "swarm"; });

}  // namespace
}  // namespace gw
