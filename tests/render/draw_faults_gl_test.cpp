// Every CUDA call on the way to OpenGL fails once while a game is drawn: that very frame shows the right picture, and
// the game goes on with the cpu device. Only where a stand-in for CUDA can be told to fail.
#include <gtest/gtest.h>

#include "game/session/failover.h"
#include "game/tables/tables.h"
#include "game/view/world_renderer.h"
#include "render/screenshot.h"
#include "tests/fake_cuda/stand_in.h"
#include "tests/render/cuda_gl_fixture.h"

namespace gw {
namespace {

using GameRun = Run;  // within a test, Run is the test framework's

constexpr uint32_t kFrames = 5;  // once round the ring and on

class DrawFaults : public CudaGlTest, public testing::WithParamInterface<cudaError_t> {
 protected:
  void SetUp() override {
    CudaGlTest::SetUp();
    if (IsSkipped()) return;
    config_.rules = loadRules(readRuleTexts(kAssets));
    config_.enemies = 64;
    config_.mode = Mode::swarm;
    config_.autopilot = Autopilot::expert;
    config_.threads = 1;
  }
  void TearDown() override {
    stand_in::restart({});
    CudaGlTest::TearDown();
  }

  std::unique_ptr<GameRun> lastingRun() {
    return std::make_unique<GameRun>(std::make_unique<Failover>(
                                         cuda::makeSimulation(config_), [this] { return cpu::makeSimulation(config_); },
                                         [this](const std::string& why) { told_.push_back(why); }),
                                     std::nullopt);
  }

  // A tick and a frame, several times.
  std::vector<Image> play(GameRun& run) {
    WorldRenderer view(kAssets);
    FollowCamera camera(run.simulation().worldWidth_m(), run.simulation().worldHeight_m());
    std::vector<Image> images;
    for (uint32_t frame = 0; frame < kFrames; ++frame) {
      run.tick({});
      camera.snap(cameraTarget(run.last(), 1), float(kSize.width) / float(kSize.height));
      context_->bindTarget();
      view.draw(run, config_.rules, camera, {kSize}, [](Canvas&) {});
      images.push_back(readPixels(kSize));
    }
    return images;
  }

  SimulationConfig config_;
  std::vector<std::string> told_;
};

TEST_P(DrawFaults, AreNotSeen) {
  GameRun onCpu(cpu::makeSimulation(config_), std::nullopt);
  const std::vector<Image> expected = play(onCpu);
  stand_in::restart({});
  const auto undisturbed = lastingRun();
  const uint64_t before = stand_in::calls();
  play(*undisturbed);
  const uint64_t after = stand_in::calls();
  EXPECT_TRUE(told_.empty());
  for (uint64_t call = before + 1; call <= after; ++call) {
    told_.clear();
    stand_in::restart({.fault = {"*", call, GetParam()}});
    const auto run = lastingRun();
    const std::vector<Image> seen = play(*run);
    const std::string what = "call " + std::to_string(call) + ", " + stand_in::struck();
    for (uint32_t frame = 0; frame < kFrames; ++frame) {
      EXPECT_EQ(seen[frame].rgb, expected[frame].rgb) << what << ", frame " << frame;
    }
    EXPECT_LE(told_.size(), 1u) << what;  // asking who shares memory may fail without harm
    EXPECT_EQ(run->simulation().onCuda(), told_.empty()) << what;
    EXPECT_EQ(stand_in::resourcesLeftMapped(), 0u) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(Errors, DrawFaults, testing::Values(cudaErrorMemoryAllocation, cudaErrorLaunchFailure),
                         [](const auto& info) { return cudaGetErrorName(info.param) + 9; });

}  // namespace
}  // namespace gw
