// Particles and bends of the background, by what they change in the picture.
#include <algorithm>
#include <array>
#include <cmath>

#include "render/grid_pass.h"
#include "render/particle_pass.h"
#include "render/screenshot.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/image_compare.h"

namespace gw {
namespace {

constexpr Camera kCamera{48, 45, 16, 9};  // 20 pixels per metre

struct Box {
  int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
};

int column(float x_m) {
  return int((x_m - kCamera.centre_x + 16) * 20);
}
int row(float y_m) {
  return int((kCamera.centre_y + 9 - y_m) * 20);
}

// Where two pictures differ by more than the rounding of a line cut into other pieces.
Box differenceOf(const Image& a, const Image& b) {
  Box box;
  for (int y = 0; y < a.size.height; ++y) {
    for (int x = 0; x < a.size.width; ++x) {
      const size_t at = (size_t(y) * size_t(a.size.width) + size_t(x)) * 3;
      int most = 0;
      for (size_t channel = at; channel < at + 3; ++channel)
        most = std::max(most, std::abs(a.rgb[channel] - b.rgb[channel]));
      if (most <= 4) continue;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    }
  }
  return box;
}

int lightAt(const Image& image, float x_m, float y_m) {
  const size_t at = (size_t(row(y_m)) * size_t(image.size.width) + size_t(column(x_m))) * 3;
  return image.rgb[at] + image.rgb[at + 1] + image.rgb[at + 2];
}

class ParticlesGl : public GlTest {
 protected:
  Image draw(const std::vector<ParticleVertex>& particles, float brightness = 1, float background = 0) {
    MappedStream<ParticleVertex> stream(64);
    ParticlePass pass(kAssets);
    glClearColor(background, background, background, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const ParticleRegion region = stream.begin();
    EXPECT_EQ(region.command->vertexCount, 3u);
    EXPECT_EQ(region.command->instanceCount, 0u);
    std::copy(particles.begin(), particles.end(), region.vertices);
    region.command->instanceCount = uint32_t(particles.size());
    stream.written();
    pass.draw(region, {kCamera, kSize, brightness});
    stream.end();
    return readPixels(kSize);
  }
};

TEST_F(ParticlesGl, AStreakReachesFromItsTailToItsHeadAndNoFurther) {
  const Image image = draw({{50, 46, 47, 46, .1f, 1, 0xFFFFFF}});
  EXPECT_GT(lightAt(image, 49.8f, 46), 3 * 200);
  EXPECT_GT(lightAt(image, 48.5f, 46), 100);
  EXPECT_GT(lightAt(image, 49.5f, 46), lightAt(image, 47.5f, 46));  // its light falls off towards the tail
  const Box box = differenceOf(image, draw({}));
  EXPECT_NEAR(box.left, column(47), 12);
  EXPECT_NEAR(box.right, column(50), 4);
  EXPECT_LE(box.bottom - box.top, 8);
}

TEST_F(ParticlesGl, OneAtRestIsADot) {
  const Box box = differenceOf(draw({{50, 46, 50, 46, .1f, 1, 0xFFFFFF}}), draw({}));
  EXPECT_NEAR(box.left, column(50), 10);
  EXPECT_NEAR(box.right, column(50), 6);
}

TEST_F(ParticlesGl, LightIsAddedInItsColour) {
  const ParticleVertex green{50, 46, 47, 46, .1f, .3f, 0x00FF00};
  const Image one = draw({green}, 1, .2f), two = draw({green, green}, 1, .2f);
  const size_t at = (size_t(row(46)) * size_t(one.size.width) + size_t(column(49.5f))) * 3;
  EXPECT_GT(one.rgb[at + 1], one.rgb[at] + 20);
  EXPECT_GE(one.rgb[at], 51);
  EXPECT_NEAR(two.rgb[at + 1] - one.rgb[at + 1], one.rgb[at + 1] - 51, 3);
}

TEST_F(ParticlesGl, AllWithoutLightIsNone) {
  const Image none = draw({});
  EXPECT_EQ(draw({{50, 46, 47, 46, .1f, 0, 0xFFFFFF}}).rgb, none.rgb);
  EXPECT_EQ(draw({{50, 46, 47, 46, .1f, 1, 0xFFFFFF}}, 0).rgb, none.rgb);
  EXPECT_EQ(draw({{150, 46, 147, 46, .1f, 1, 0xFFFFFF}}).rgb, none.rgb);  // out of view
}

class GridBendsGl : public GlTest {
 protected:
  Image draw(std::span<const GridBend> bends, const Camera& camera = kCamera, float unrest = 0) {
    GridPass pass(kAssets);
    pass.draw({.camera = camera, .target = kSize, .time_s = 2, .unrest = unrest, .bends = bends});
    return readPixels(kSize);
  }
};

TEST_F(GridBendsGl, BendWithinTheirWidthOnly) {
  const GridBend dent{50, 46, 0, 3, 1};
  const Box box = differenceOf(draw({&dent, 1}), draw({}));
  ASSERT_GT(box.right, 0) << "nothing bends";
  EXPECT_GE(box.left, column(47) - 2);
  EXPECT_LE(box.right, column(53) + 2);
  EXPECT_GE(box.top, row(49) - 2);
  EXPECT_LE(box.bottom, row(43) + 2);
}

TEST_F(GridBendsGl, MoveALineOutwards) {
  const GridBend ripple{50, 46, 2, 2, 1};  // the line at x = 52 is where it moves most
  const Image still = draw({}), bent = draw({&ripple, 1});
  EXPECT_GT(lightAt(still, 52.02f, 46), lightAt(still, 53.02f, 46) + 10);
  EXPECT_GT(lightAt(bent, 53.02f, 46), lightAt(bent, 52.02f, 46) + 10);
}

TEST_F(GridBendsGl, OfNoStrengthChangeNothing) {
  const std::array<GridBend, 2> none{GridBend{50, 46, 0, 3, 0}, GridBend{45, 46, 4, 3, 0}};
  for (const float unrest : {0.0f, .8f}) {
    const ImageDifference difference = compareImages(draw(none, kCamera, unrest), draw({}, kCamera, unrest));
    EXPECT_LE(difference.largest, 4) << unrest;  // the same lines in other pieces: rounding
  }
}

TEST_F(GridBendsGl, LeaveTheWallsWhereTheyAre) {
  const Camera corner{4, 104, 16, 9};
  const GridBend dent{0, 104, 4, 6, 2};
  const Image still = draw({}, corner), bent = draw({&dent, 1}, corner);
  const size_t at = (180 * size_t(kSize.width) + 240) * 3;  // x = 0, y = 104: on the left wall
  EXPECT_GT(still.rgb[at + 2], 200);
  EXPECT_NEAR(bent.rgb[at + 2], still.rgb[at + 2], 60);
  EXPECT_GT(differenceOf(still, bent).right, 0);
}

TEST_F(GridBendsGl, AreAtMostAsManyAsTheShaderTakes) {
  std::vector<GridBend> many(kMaxGridBends + 5, GridBend{50, 46, 0, 3, .05f});
  const Image all = draw(many);
  many.resize(kMaxGridBends);
  EXPECT_EQ(all.rgb, draw(many).rgb);
}

}  // namespace
}  // namespace gw
