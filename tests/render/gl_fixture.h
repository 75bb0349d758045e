// Tests that draw: a small headless context each, or a skip (never a pass) where there is no OpenGL.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "render/gl_context_egl.h"
#include "render/gl_objects.h"
#include "tests/asset_folder.h"

namespace gw {

inline const std::filesystem::path kAssets = findAssets(std::filesystem::path(GW_SOURCE_DIR) / "assets");
inline const std::filesystem::path kGoldenImages = std::filesystem::path(GW_SOURCE_DIR) / "tests/render/golden_images";

class GlTest : public testing::Test {
 protected:
  static constexpr PixelSize kSize{640, 360};

  void SetUp() override {
    try {
      context_ = makeEglContext(kSize, cudaDevice());
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
    context_->bindTarget();
  }

  void TearDown() override {
    if (context_) {
      EXPECT_NO_THROW(checkGl("ending the test"));
    }
  }

  // Where to draw best: tests of what CUDA computes say which device does.
  virtual std::optional<int> cudaDevice() const { return std::nullopt; }

  std::unique_ptr<GlContext> context_;
};

// Runs the call and returns what it threw as text; empty when it threw nothing.
template <class Call>
std::string errorOf(Call call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace gw
