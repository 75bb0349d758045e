// What a player reads when a shader is missing or damaged.
#include <algorithm>
#include <fstream>

#include "render/asset_file.h"
#include "render/sprite_pass.h"
#include "tests/render/gl_fixture.h"

namespace gw {
namespace {

class ShaderErrors : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("shader_errors_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "shaders");
    for (const char* name : {"shaders/sprite.vert", "shaders/sprite.frag"}) {
      std::filesystem::copy_file(kAssets / name, folder_ / name);
    }
  }

  void TearDown() override {
    std::filesystem::remove_all(folder_);
    GlTest::TearDown();
  }

  std::filesystem::path folder_;
};

TEST_F(ShaderErrors, aCopyOfTheShadersCompiles) {
  EXPECT_EQ("", errorOf([&] { SpritePass pass(folder_); }));
}

TEST_F(ShaderErrors, aMissingOneIsNamed) {
  std::filesystem::remove(folder_ / "shaders/sprite.frag");
  const std::string error = errorOf([&] { SpritePass pass(folder_); });
  EXPECT_NE(error.find("shaders/sprite.frag"), std::string::npos) << error;
  EXPECT_NE(error.find("GpuWars package"), std::string::npos) << error;
}

TEST_F(ShaderErrors, aDamagedOneIsNamedWithItsLine) {
  std::string source = readAsset(kAssets, "shaders/sprite.frag");
  const size_t body = source.find("void main");
  const auto line = 1 + std::count(source.begin(), source.begin() + ptrdiff_t(body), '\n');
  source.insert(body, "nonsense ");
  std::ofstream(folder_ / "shaders/sprite.frag") << source;
  const std::string error = errorOf([&] { SpritePass pass(folder_); });
  EXPECT_NE(error.find("shaders/sprite.frag, line " + std::to_string(line) + ":"), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

TEST_F(ShaderErrors, onesThatDoNotFitTogetherAreNamed) {
  std::ofstream(folder_ / "shaders/sprite.frag")
      << "#version 450 core\nin vec3 nobodyWritesThis;\nout vec4 c;\nvoid main() { c = nobodyWritesThis.xyzx; }\n";
  const std::string error = errorOf([&] { SpritePass pass(folder_); });
  EXPECT_NE(error.find("shaders/sprite.frag"), std::string::npos) << error;
}

TEST_F(ShaderErrors, aFailedGlCallSaysWhatWasBeingDone) {
  glEnable(0x1234);  // no such capability
  const std::string error = errorOf([] { checkGl("drawing the sprites"); });
  EXPECT_NE(error.find("drawing the sprites"), std::string::npos) << error;
  EXPECT_EQ("", errorOf([] { checkGl("drawing the sprites"); }));
}

TEST_F(ShaderErrors, ownersMoveAndDeleteOnce) {
  GlBuffer first = makeGlBuffer(64, nullptr, 0);
  const GLuint name = first.get();
  GlBuffer second = std::move(first);
  EXPECT_FALSE(first);
  EXPECT_EQ(second.get(), name);
  EXPECT_TRUE(glIsBuffer(name));
  { const GlBuffer last = std::move(second); }
  EXPECT_FALSE(glIsBuffer(name));
}

}  // namespace
}  // namespace gw
