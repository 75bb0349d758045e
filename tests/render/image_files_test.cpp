// Files: assets that are not there, pictures encoded and read again. No OpenGL.
#include <gtest/gtest.h>

#include <fstream>

#include "render/asset_file.h"
#include "render/screenshot.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/image_compare.h"

namespace gw {
namespace {

namespace fs = std::filesystem;

class ImageFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("image_files_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static Image pattern() {
    Image image{{31, 17}, {}};
    for (int i = 0; i < 31 * 17 * 3; ++i) image.rgb.push_back(uint8_t(i * 7));
    return image;
  }

  fs::path folder_;
};

TEST_F(ImageFiles, aPictureIsReadAsItWasEncoded) {
  writePng(folder_ / "picture.png", pattern());
  const ImageDifference difference = compareImages(readPng(folder_ / "picture.png"), pattern());
  EXPECT_TRUE(difference.sameSize);
  EXPECT_EQ(difference.largest, 0);
}

TEST_F(ImageFiles, aMissingAssetIsNamed) {
  const std::string error = errorOf([&] { readAsset(folder_, "shaders/none.vert"); });
  EXPECT_NE(error.find("shaders/none.vert"), std::string::npos) << error;
  EXPECT_NE(error.find("GpuWars package"), std::string::npos) << error;
}

TEST_F(ImageFiles, aFolderIsNoAsset) {
  EXPECT_NE("", errorOf([&] { readAsset(folder_.parent_path(), folder_.filename().string()); }));
}

TEST_F(ImageFiles, anAssetIsReadWhole) {
  const std::string text("first\0second\nthird", 18);
  std::ofstream(folder_ / "asset", std::ios::binary) << text;
  EXPECT_EQ(readAsset(folder_, "asset"), text);
}

TEST(ImageCompare, noticesEveryKindOfDifference) {
  const Image black{{64, 64}, std::vector<uint8_t>(64 * 64 * 3)};
  EXPECT_TRUE(withinTolerance(compareImages(black, black)));
  Image spot = black;
  spot.rgb[3000] = uint8_t(kLargestDifference + 1);
  EXPECT_FALSE(withinTolerance(compareImages(black, spot))) << "one pixel far off";
  Image veil = black;
  for (uint8_t& channel : veil.rgb) channel = 1;
  EXPECT_FALSE(withinTolerance(compareImages(black, veil))) << "every pixel slightly off";
  EXPECT_FALSE(withinTolerance(compareImages(black, Image{{32, 128}, black.rgb}))) << "another size";
}

TEST(ImageCompare, aGoldenPictureMovedByOnePixelFails) {
  const Image golden = readPng(kGoldenImages / "shapes.png");
  EXPECT_TRUE(withinTolerance(compareImages(golden, golden)));
  EXPECT_FALSE(withinTolerance(compareImages(golden, shiftedImage(golden, 1))));
}

}  // namespace
}  // namespace gw
