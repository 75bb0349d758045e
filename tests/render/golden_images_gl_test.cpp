// Fixed scenes against the pictures in tests/render/golden_images. To renew them after an intended change: run this
// test with GW_UPDATE_GOLDEN_IMAGES=1, look at the pictures, commit them with the reason.
#include <algorithm>

#include "render/grid_pass.h"
#include "render/quad_pass.h"
#include "render/ring_pass.h"
#include "render/screenshot.h"
#include "render/sprite_pass.h"
#include "render/vertex_stream.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/image_compare.h"
#include "tests/render/sprite_scene.h"

namespace gw {
namespace {

class GoldenImages : public GlTest {
 protected:
  // The scene's sprites on black.
  Image drawSprites(const std::vector<SpriteVertex>& sprites, SpriteFrame frame) {
    VertexStream stream(uint32_t(sprites.size()));
    SpritePass pass(kAssets);
    context_->bindTarget();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const StreamRegion region = stream.begin();
    std::copy(sprites.begin(), sprites.end(), region.vertices);
    region.command->instanceCount = uint32_t(sprites.size());
    stream.written();
    frame.target = kSize;
    frame.announced_ticks = 30;
    pass.draw(region, frame);
    stream.end();
    return readPixels(kSize);
  }
};

constexpr Camera kSceneCamera{0, 0, 20, 11.25f};

TEST_F(GoldenImages, everyShapeInEveryCondition) {
  const Image image =
      drawSprites(shapeScene(3.6f, 2.7f), {.camera = kSceneCamera, .target = {}, .alpha = .5f, .tick = 6});
  EXPECT_EQ("", compareWithGolden(image, "shapes.png"));
}

TEST_F(GoldenImages, everyShapeWithMuchGlowAndWithoutFlashes) {
  const Image image =
      drawSprites(shapeScene(3.6f, 2.7f),
                  {.camera = kSceneCamera, .target = {}, .alpha = .5f, .tick = 6, .glow = kGlowHigh, .flashes = false});
  EXPECT_EQ("", compareWithGolden(image, "shapes_high_glow.png"));
}

TEST_F(GoldenImages, backgroundRingAndBars) {
  GridPass grid(kAssets);
  RingPass rings(kAssets);
  QuadPass quads(kAssets);
  const Camera camera{176, 98, 35.6f, 20};
  context_->bindTarget();
  grid.draw({.camera = camera, .target = kSize, .time_s = 3.25f, .unrest = .8f});
  rings.draw({174, 96, 8, 3, .6f, rgbaOf(0x60C0FF)}, camera, kSize);
  quads.rectangle(10, 10, 120, 8, rgbaOf(0x203040, .8f));
  quads.gradient(10, 10, 90, 8, rgbaOf(0x30FF60), rgbaOf(0xFF4030));
  quads.outline(8, 8, 124, 12, 1, rgbaOf(0x80A0C0));
  quads.line(20, 300, 120, 340, 3, rgbaOf(0xFFFFFF, .5f));
  quads.triangle(200, 340, 220, 340, 210, 320, rgbaOf(0xFFB020));
  quads.flush(kSize);
  EXPECT_EQ("", compareWithGolden(readPixels(kSize), "background.png"));
}

TEST_F(GoldenImages, aPictureMovedByOnePixelFails) {
  const Image image =
      drawSprites(shapeScene(3.6f, 2.7f), {.camera = kSceneCamera, .target = {}, .alpha = .5f, .tick = 6});
  const ImageDifference difference = compareImages(image, shiftedImage(image, 1));
  EXPECT_GT(difference.largest, kLargestDifference);
  EXPECT_GT(difference.mean, kMeanDifference);
}

TEST_F(GoldenImages, spritesMoveFromTheirPreviousPlace) {
  SpriteVertex moving = sceneSprite(2, 5, 0, 0);
  moving.previous_x = -5;
  const SpriteVertex there = sceneSprite(2, 5, 0, 0), before = sceneSprite(2, -5, 0, 0),
                     midway = sceneSprite(2, 0, 0, 0);
  const auto draw = [&](const SpriteVertex& sprite, float alpha) {
    return drawSprites({sprite}, {.camera = kSceneCamera, .target = {}, .alpha = alpha});
  };
  EXPECT_TRUE(withinTolerance(compareImages(draw(moving, 0), draw(before, 1))));
  EXPECT_TRUE(withinTolerance(compareImages(draw(moving, .5f), draw(midway, 1))));
  EXPECT_TRUE(withinTolerance(compareImages(draw(moving, 1), draw(there, 1))));
  EXPECT_FALSE(withinTolerance(compareImages(draw(moving, 0), draw(there, 1))));
}

TEST_F(GoldenImages, everyShapeDiffersFromEveryOtherWithoutColour) {
  std::vector<Image> images;
  for (uint32_t shape = 0; shape < kSceneShapeCount; ++shape) {
    SpriteVertex sprite = sceneSprite(shape, 0, 0, 0);
    sprite.size_m = .6f;  // 11 pixels of half extent, as the game shows a fragment
    sprite.colour = 0xFFFFFF;
    images.push_back(drawSprites({sprite}, {.camera = {0, 0, 1.78f, 1}, .target = {}}));
  }
  for (size_t a = 0; a < images.size(); ++a) {
    for (size_t b = 0; b < a; ++b) EXPECT_GT(compareImages(images[a], images[b]).mean, 1) << a << " and " << b;
  }
}

TEST_F(GoldenImages, whatIsLaterInTheListCoversWhatIsEarlier) {
  SpriteVertex below = sceneSprite(7, 0, 0, 0), above = sceneSprite(2, 0, 0, 0, 0, 0);
  below.size_m = 1;
  const Camera close{0, 0, 3.56f, 2};
  const Image covered = drawSprites({below, above}, {.camera = close, .target = {}});
  const Image open = drawSprites({above, below}, {.camera = close, .target = {}});
  const size_t middle = (size_t(kSize.height / 2) * size_t(kSize.width) + size_t(kSize.width / 2)) * 3;
  EXPECT_LT(covered.rgb[middle] * 2, open.rgb[middle]);
}

}  // namespace
}  // namespace gw
