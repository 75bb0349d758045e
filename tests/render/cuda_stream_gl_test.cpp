// Sprites on their way from a CUDA device to OpenGL: what arrives is what MappedStream would show, frame by frame,
// shared and copied.
#include <algorithm>

#include "render/cuda_interop.h"
#include "render/gl_renderers.h"
#include "render/screenshot.h"
#include "render/sprite_pass.h"
#include "tests/render/cuda_gl_fixture.h"
#include "tests/render/cuda_sprites.h"
#include "tests/render/sprite_scene.h"

namespace gw {
namespace {

constexpr Camera kCamera{0, 0, 16, 9};

class CudaStreamGl : public CudaGlTest, public testing::WithParamInterface<Sharing> {
 protected:
  void SetUp() override {
    CudaGlTest::SetUp();
    if (!IsSkipped()) pass_ = std::make_unique<SpritePass>(kAssets);
  }

  static void clear() {
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }

  void drawWith(SpriteStream& stream, const std::vector<SpriteVertex>& sprites) {
    const StreamRegion region = stream.begin();
    writeOnCuda(region, sprites);
    stream.written();
    pass_->draw(region, {.camera = kCamera, .target = kSize});
    stream.end();
  }

  // What MappedStream shows of the same.
  Image expected(const std::vector<SpriteVertex>& sprites) {
    VertexStream stream(uint32_t(sprites.size()) + 1);
    clear();
    const StreamRegion region = stream.begin();
    std::copy(sprites.begin(), sprites.end(), region.vertices);
    region.command->instanceCount = uint32_t(sprites.size());
    stream.written();
    pass_->draw(region, {.camera = kCamera, .target = kSize});
    stream.end();
    return readPixels(kSize);
  }

  static std::vector<SpriteVertex> someSprites(int frame) {
    std::vector<SpriteVertex> sprites;
    for (int i = 0; i <= frame % 5; ++i) {
      sprites.push_back(sceneSprite(uint32_t(frame + i) % kSceneShapeCount, float(frame) - 5 + float(i), float(i) - 2,
                                    float(frame) * 0.3f));
    }
    return sprites;
  }

  std::unique_ptr<SpritePass> pass_;
};

TEST_P(CudaStreamGl, EveryFrameEqualsTheMappedOne) {
  const auto made = makeCudaStream<SpriteVertex>(8, GetParam());
  constexpr int kFrames = 11;  // three times round the ring and a little more
  for (int frame = 0; frame < kFrames; ++frame) {
    clear();
    drawWith(*made.stream, someSprites(frame));
    const Image image = readPixels(kSize);
    EXPECT_EQ(image.rgb, expected(someSprites(frame)).rgb) << "frame " << frame;
    EXPECT_GT(*std::max_element(image.rgb.begin(), image.rgb.end()), 60) << "frame " << frame << " shows nothing";
  }
}

TEST_P(CudaStreamGl, FramesInFlightKeepTheirSprites) {
  const auto made = makeCudaStream<SpriteVertex>(1, GetParam());
  std::vector<SpriteVertex> all;
  clear();
  for (int frame = 0; frame < 3; ++frame) {
    all.push_back(sceneSprite(7, float(frame * 4 - 4), 0, 0));
    drawWith(*made.stream, {all.back()});
  }
  const Image image = readPixels(kSize);
  EXPECT_EQ(image.rgb, expected(all).rgb);
}

TEST_P(CudaStreamGl, HasThreeRegionsInTurn) {
  const auto made = makeCudaStream<SpriteVertex>(8, GetParam());
  std::vector<std::pair<GLuint, size_t>> vertices, commands;
  for (uint32_t i = 0; i < 2 * SpriteStream::kRegions; ++i) {
    const StreamRegion region = made.stream->begin();
    made.stream->written();
    made.stream->end();
    vertices.emplace_back(region.vertexBuffer, region.vertexOffset_bytes);
    commands.emplace_back(region.commandBuffer, region.commandOffset_bytes);
  }
  for (uint32_t i = 0; i < SpriteStream::kRegions; ++i) {
    EXPECT_EQ(vertices[i], vertices[i + SpriteStream::kRegions]);
    EXPECT_EQ(commands[i], commands[i + SpriteStream::kRegions]);
    EXPECT_NE(vertices[i], vertices[i + 1]);
    EXPECT_NE(vertices[i], vertices[i + 2]);
    EXPECT_NE(commands[i], commands[i + 1]);
    EXPECT_NE(commands[i], commands[i + 2]);
  }
}

TEST_P(CudaStreamGl, AFrameWithoutSpritesDrawsNothing) {
  const auto made = makeCudaStream<SpriteVertex>(8, GetParam());
  for (uint32_t i = 0; i < SpriteStream::kRegions; ++i) drawWith(*made.stream, someSprites(int(i)));
  for (uint32_t i = 0; i < SpriteStream::kRegions; ++i) {  // whatever each region held before
    clear();
    const StreamRegion region = made.stream->begin();
    made.stream->written();
    pass_->draw(region, {.camera = kCamera, .target = kSize});
    made.stream->end();
    const Image image = readPixels(kSize);
    EXPECT_EQ(std::count(image.rgb.begin(), image.rgb.end(), 0), ptrdiff_t(image.rgb.size()));
  }
}

TEST_P(CudaStreamGl, AWriterThatCountsTooManyDrawsWhatFits) {
  constexpr uint32_t kCapacity = 3;
  const auto made = makeCudaStream<SpriteVertex>(kCapacity, GetParam());
  const std::vector<SpriteVertex> sprites = someSprites(4);
  ASSERT_GT(sprites.size(), kCapacity);
  clear();
  drawWith(*made.stream, sprites);
  const Image image = readPixels(kSize);
  EXPECT_EQ(image.rgb, expected({sprites.begin(), sprites.begin() + kCapacity}).rgb);
}

TEST_P(CudaStreamGl, AnAbandonedFrameDoesNotSpoilTheNext) {
  const auto made = makeCudaStream<SpriteVertex>(8, GetParam());
  clear();
  writeOnCuda(made.stream->begin(), someSprites(3));  // its writer failed: no written(), no end()
  drawWith(*made.stream, someSprites(2));
  const Image image = readPixels(kSize);
  EXPECT_EQ(image.rgb, expected(someSprites(2)).rgb);
}

INSTANTIATE_TEST_SUITE_P(Ways, CudaStreamGl, testing::Values(Sharing::wherePossible, Sharing::never),
                         [](const auto& info) { return info.param == Sharing::never ? "copied" : "shared"; });

using CudaSharing = CudaGlTest;

TEST_F(CudaSharing, IsUsedWhereOneGpuDoesBothAndElseSaysWhyNot) {
  const auto made = makeCudaStream<SpriteVertex>(8);
  EXPECT_EQ(made.shared, made.why.empty());
  bool oneGpu = false;
  for (const GlRenderer& renderer : listGlRenderers()) oneGpu |= renderer.cudaDevice == currentCudaDevice();
  context_->makeCurrent();
  if (!oneGpu) GTEST_SKIP() << "no EGL device is the CUDA device: " << made.why;
  EXPECT_TRUE(made.shared) << made.why;
}

}  // namespace
}  // namespace gw
