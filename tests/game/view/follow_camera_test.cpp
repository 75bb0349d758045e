#include "game/view/follow_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gw {
namespace {

constexpr float kWide = 16.0f / 9.0f;

FollowCamera settled(const FollowCamera::Target& target, float dt = 1.0f / 60) {
  FollowCamera camera(192, 108);
  camera.snap({96, 54, 0, 0}, kWide);
  for (float t = 0; t < 20; t += dt) camera.follow(target, kWide, dt);
  return camera;
}

TEST(CameraTest, ShowsFortyMetresAndLooksAheadAlongTheAim) {
  const FollowCamera camera = settled({80, 50, float(std::numbers::pi / 2), 0});
  EXPECT_NEAR(camera.x(), 80, 1e-3);
  EXPECT_NEAR(camera.y(), 54, 1e-3);
  EXPECT_NEAR(camera.halfHeight_m(), 20, 1e-3);
  EXPECT_NEAR(camera.halfWidth_m(), 20 * kWide, 1e-3);
}

TEST(CameraTest, FollowsAlikeAtEveryFrameRate) {
  FollowCamera slow(192, 108), fast(192, 108);
  const FollowCamera::Target target{116, 44, 0, 0};
  for (int i = 0; i < 15; ++i) slow.follow(target, kWide, 1.0f / 30);
  for (int i = 0; i < 120; ++i) fast.follow(target, kWide, 1.0f / 240);
  EXPECT_NEAR(slow.x(), fast.x(), 1e-3);
  // Spring 8/s: after half a second exp(-4) of the gap is left.
  EXPECT_NEAR(slow.x(), 96 + 24 * (1 - std::exp(-4.0f)), 1e-3);
}

TEST(CameraTest, ShowsAtMostFourMetresPastEveryWall) {
  const FollowCamera topRight = settled({192, 108, 0.8f, 0}), bottomLeft = settled({0, 0, 4.0f, 0});
  EXPECT_NEAR(topRight.x() + topRight.halfWidth_m(), 192 + 4, 1e-3);
  EXPECT_NEAR(topRight.y() + topRight.halfHeight_m(), 108 + 4, 1e-3);
  EXPECT_NEAR(bottomLeft.x() - bottomLeft.halfWidth_m(), -4, 1e-3);
  EXPECT_NEAR(bottomLeft.y() - bottomLeft.halfHeight_m(), -4, 1e-3);
}

TEST(CameraTest, CentresAWorldThatFitsTheView) {
  FollowCamera camera(40, 20);
  camera.snap({35, 18, 0, 0}, kWide);
  EXPECT_EQ(camera.x(), 20);
  EXPECT_EQ(camera.y(), 10);
}

TEST(CameraTest, WidensWithTheCrowd) {
  EXPECT_NEAR(settled({0, 0, 0, 600}).halfHeight_m(), 20, 1e-3);
  EXPECT_NEAR(settled({0, 0, 0, 1300}).halfHeight_m(), 23, 1e-3);
  EXPECT_NEAR(settled({0, 0, 0, 2000}).halfHeight_m(), 26, 1e-3);
  EXPECT_NEAR(settled({0, 0, 0, 100000}).halfHeight_m(), 26, 1e-3);
}

TEST(CameraTest, PixelsAndMetresAreInverse) {
  const FollowCamera camera = settled({30, 20, 1, 900});
  float x, y, px, py;
  camera.toWorld(200, 600, 1280, 720, x, y);
  camera.toPixels(x, y, 1280, 720, px, py);
  EXPECT_NEAR(px, 200, 1e-2);
  EXPECT_NEAR(py, 600, 1e-2);
  camera.toWorld(640, 0, 1280, 720, x, y);
  EXPECT_NEAR(y, camera.y() + camera.halfHeight_m(), 1e-3) << "the top of the window is up";
}

}  // namespace
}  // namespace gw
