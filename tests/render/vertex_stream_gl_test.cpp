// The ring of regions: frames never see each other's sprites, however often it goes round.
#include <algorithm>
#include <set>

#include "render/screenshot.h"
#include "render/sprite_pass.h"
#include "render/vertex_stream.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/sprite_scene.h"

namespace gw {
namespace {

using VertexStreamRing = GlTest;

constexpr Camera kCamera{0, 0, 16, 9};  // 20 pixels per metre

bool isLit(const Image& image, float x_m, float y_m) {
  const int column = int((x_m + 16) * 20), row = int((9 - y_m) * 20);
  const size_t at = (size_t(row) * size_t(image.size.width) + size_t(column)) * 3;
  return image.rgb[at] + image.rgb[at + 1] + image.rgb[at + 2] > 60;
}

TEST_F(VertexStreamRing, everyFrameShowsItsOwnSpritesOnly) {
  VertexStream stream(8);
  SpritePass pass(kAssets);
  constexpr int kFrames = 11;  // three times round the ring and a little more
  for (int frame = 0; frame < kFrames; ++frame) {
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const StreamRegion region = stream.begin();
    region.vertices[0] = sceneSprite(7, float(frame) - 5, 0, 0);
    region.vertices[1] = sceneSprite(7, float(frame) - 5, 3, 0);
    region.command->instanceCount = 2;
    stream.written();
    pass.draw(region, {.camera = kCamera, .target = kSize});
    stream.end();
    const Image image = readPixels(kSize);
    for (int other = 0; other < kFrames; ++other) {
      EXPECT_EQ(isLit(image, float(other) - 5, 0), other == frame) << "frame " << frame << ", place " << other;
      EXPECT_EQ(isLit(image, float(other) - 5, 3), other == frame) << "frame " << frame << ", place " << other;
    }
  }
}

TEST_F(VertexStreamRing, framesInFlightKeepTheirSprites) {
  // Three frames are queued over one picture before anything is read back.
  VertexStream stream(1);
  SpritePass pass(kAssets);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  for (int frame = 0; frame < 3; ++frame) {
    const StreamRegion region = stream.begin();
    region.vertices[0] = sceneSprite(7, float(frame * 4 - 4), 0, 0);
    region.command->instanceCount = 1;
    stream.written();
    pass.draw(region, {.camera = kCamera, .target = kSize});
    stream.end();
  }
  const Image image = readPixels(kSize);
  EXPECT_TRUE(isLit(image, -4, 0) && isLit(image, 0, 0) && isLit(image, 4, 0));
}

TEST_F(VertexStreamRing, hasThreeRegionsThatDoNotOverlap) {
  constexpr uint32_t kCapacity = 100;
  VertexStream stream(kCapacity);
  std::vector<size_t> offsets;
  std::set<const void*> commands;
  for (uint32_t i = 0; i < 2 * SpriteStream::kRegions; ++i) {
    const StreamRegion region = stream.begin();
    EXPECT_EQ(region.capacity, kCapacity);
    EXPECT_EQ(region.command->vertexCount, SpriteStream::kDrawNothing.vertexCount);
    EXPECT_EQ(region.command->instanceCount, 0u);
    region.command->instanceCount = 7;  // left behind for the next round
    offsets.push_back(region.vertexOffset_bytes);
    commands.insert(region.command);
    stream.end();
  }
  for (uint32_t i = 0; i < SpriteStream::kRegions; ++i) {
    EXPECT_EQ(offsets[i], offsets[i + SpriteStream::kRegions]);
    EXPECT_EQ(offsets[i], i * kCapacity * sizeof(SpriteVertex));
  }
  EXPECT_EQ(commands.size(), size_t(SpriteStream::kRegions));
}

TEST_F(VertexStreamRing, aFrameWithoutSpritesDrawsNothing) {
  VertexStream stream(8);
  SpritePass pass(kAssets);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const StreamRegion region = stream.begin();
  stream.written();
  pass.draw(region, {.camera = kCamera, .target = kSize});
  stream.end();
  const Image image = readPixels(kSize);
  EXPECT_EQ(std::count(image.rgb.begin(), image.rgb.end(), 0), ptrdiff_t(image.rgb.size()));
}

}  // namespace
}  // namespace gw
