// Every CUDA call of a stream fails once: what comes out is a DeviceError or the right picture, nothing stays mapped,
// and OpenGL draws on. Only where a stand-in for CUDA can be told to fail.
#include <gtest/gtest.h>

#include "render/cuda_interop.h"
#include "render/screenshot.h"
#include "render/sprite_pass.h"
#include "tests/fake_cuda/stand_in.h"
#include "tests/render/cuda_gl_fixture.h"
#include "tests/render/cuda_sprites.h"
#include "tests/render/sprite_scene.h"

namespace gw {
namespace {

constexpr Camera kCamera{0, 0, 16, 9};

class CudaStreamFaults : public CudaGlTest, public testing::WithParamInterface<std::tuple<Sharing, cudaError_t>> {
 protected:
  void SetUp() override {
    CudaGlTest::SetUp();
    if (IsSkipped()) return;
    pass_ = std::make_unique<SpritePass>(kAssets);
    VertexStream stream(8);
    expected_ = drawWith(stream, [this](const StreamRegion& region) {
      std::copy(sprites_.begin(), sprites_.end(), region.vertices);
      region.command->instanceCount = uint32_t(sprites_.size());
    });
  }
  void TearDown() override {
    stand_in::restart({});
    CudaGlTest::TearDown();
  }

  template <class Write>
  Image drawWith(SpriteStream& stream, const Write& write) {
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const StreamRegion region = stream.begin();
    write(region);
    stream.written();
    pass_->draw(region, {.camera = kCamera, .target = kSize});
    stream.end();
    return readPixels(kSize);
  }

  // A few frames, once round the ring and on. Returns false when a DeviceError came out.
  bool frames(Sharing sharing) {
    CudaStream<SpriteVertex> made;  // outlives the error: what it left mapped then is seen
    bool drawn = true;
    try {
      made = makeCudaStream<SpriteVertex>(8, sharing);
      for (uint32_t i = 0; i <= SpriteStream::kRegions; ++i) {
        const Image image =
            drawWith(*made.stream, [this](const StreamRegion& region) { writeOnCuda(region, sprites_); });
        EXPECT_EQ(image.rgb, expected_.rgb) << "frame " << i;
      }
    } catch (const DeviceError&) {
      drawn = false;
    }
    EXPECT_EQ(stand_in::resourcesLeftMapped(), 0u) << stand_in::struck();
    return drawn;
  }

  const std::vector<SpriteVertex> sprites_{sceneSprite(7, -3, 1, 0), sceneSprite(2, 4, -2, 1)};
  Image expected_;
  std::unique_ptr<SpritePass> pass_;
};

TEST_P(CudaStreamFaults, AreDeviceErrorsAndLeaveNothingMapped) {
  const auto [sharing, error] = GetParam();
  uint32_t thrown = 0;
  for (uint64_t number = 1;; ++number) {
    stand_in::Options options;
    options.fault = {"*", number, error};
    stand_in::restart(options);
    const bool drawn = frames(sharing);
    const std::string struck = stand_in::struck();
    if (struck.empty()) {
      EXPECT_TRUE(drawn);
      break;  // there are no more calls than this
    }
    thrown += !drawn;
    ASSERT_NO_THROW(checkGl("drawing")) << "call " << number << ", " << struck;
    ASSERT_LT(number, 1000u);
  }
  EXPECT_GT(thrown, 10u);
}

INSTANTIATE_TEST_SUITE_P(Ways, CudaStreamFaults,
                         testing::Combine(testing::Values(Sharing::wherePossible, Sharing::never),
                                          testing::Values(cudaErrorInvalidValue, cudaErrorMemoryAllocation,
                                                          cudaErrorLaunchFailure)));

}  // namespace
}  // namespace gw
