// Files: assets that are not there, pictures written and read again, paths that cannot be written. No OpenGL.
#include <gtest/gtest.h>
#include <unistd.h>

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

  size_t filesLeft() const { return size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }

  static Image pattern() {
    Image image{{31, 17}, {}};
    for (int i = 0; i < 31 * 17 * 3; ++i) image.rgb.push_back(uint8_t(i * 7));
    return image;
  }

  fs::path folder_;
};

TEST_F(ImageFiles, aPictureIsReadAsItWasWritten) {
  writePng(folder_ / "picture.png", pattern());
  const ImageDifference difference = compareImages(readPng(folder_ / "picture.png"), pattern());
  EXPECT_TRUE(difference.sameSize);
  EXPECT_EQ(difference.largest, 0);
  EXPECT_EQ(filesLeft(), 1u) << "the temporary file must be gone";
}

TEST_F(ImageFiles, anOlderPictureIsReplaced) {
  std::ofstream(folder_ / "picture.png") << "something else";
  writePng(folder_ / "picture.png", pattern());
  EXPECT_EQ(compareImages(readPng(folder_ / "picture.png"), pattern()).largest, 0);
}

TEST_F(ImageFiles, aFolderThatIsNotThereIsNamed) {
  const fs::path path = folder_ / "nowhere" / "picture.png";
  const std::string error = errorOf([&] { writePng(path, pattern()); });
  EXPECT_NE(error.find(path.string()), std::string::npos) << error;
  EXPECT_NE(error.find("choose a folder"), std::string::npos) << error;
}

TEST_F(ImageFiles, aFolderInThePicturesPlaceIsNamedAndNothingIsLeft) {
  fs::create_directories(folder_ / "picture.png");
  const std::string error = errorOf([&] { writePng(folder_ / "picture.png", pattern()); });
  EXPECT_NE(error.find("picture.png"), std::string::npos) << error;
  EXPECT_EQ(filesLeft(), 1u);
}

TEST_F(ImageFiles, aFullDiskIsNoticed) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  // The temporary file's name is fixed by the process: a link in its place sends it to a disk that is full.
  const fs::path temporary = folder_ / ("picture.png." + std::to_string(getpid()) + ".part");
  fs::create_symlink("/dev/full", temporary);
  Image large{{300, 300}, std::vector<uint8_t>(300 * 300 * 3)};
  for (size_t i = 0; i < large.rgb.size(); ++i) large.rgb[i] = uint8_t(i * i * 31 >> 3);
  const std::string error = errorOf([&] { writePng(folder_ / "picture.png", large); });
  EXPECT_NE(error.find("disk"), std::string::npos) << error;
  EXPECT_EQ(filesLeft(), 0u);
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
