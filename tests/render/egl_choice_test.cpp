// Where a headless context is opened, on machines as they are met: no EGL is asked here.
#include "render/egl_choice.h"

#include <gtest/gtest.h>

namespace gw {
namespace {

using Order = std::vector<size_t>;

const EglPlace kSurfaceless{true, "", {}};
const EglPlace kSoftware{false, "EGL_MESA_device_software EGL_EXT_device_drm_render_node", {}};
const EglPlace kOtherVendor{false, "EGL_EXT_device_drm EGL_EXT_device_drm_render_node", {}};

EglPlace nvidia(int ordinal) {
  return {false, "EGL_NV_device_cuda EGL_EXT_device_drm", ordinal};
}

TEST(EglChoice, WithoutCudaTheSurfacelessPlatformComesFirst) {
  EXPECT_EQ(eglOrder({nvidia(0), kSurfaceless, kSoftware}, {}), (Order{1, 0, 2}));
  EXPECT_EQ(eglOrder({kSurfaceless, nvidia(0)}, {}), (Order{0, 1}));
}

TEST(EglChoice, TheDeviceThatComputesDraws) {
  EXPECT_EQ(eglOrder({kSurfaceless, nvidia(0), kSoftware}, 0), (Order{1, 0, 2}));
  EXPECT_EQ(eglOrder({kSurfaceless, kOtherVendor, nvidia(0), nvidia(1)}, 1), (Order{3, 0, 1, 2}));
}

TEST(EglChoice, OrdinalsNeedNotBeInEglsOrder) {
  EXPECT_EQ(eglOrder({kSurfaceless, nvidia(1), nvidia(0)}, 0), (Order{2, 0, 1}));
}

TEST(EglChoice, WhereTheDeviceThatComputesCannotDrawItIsAsWithoutCuda) {
  EXPECT_EQ(eglOrder({kSurfaceless, kSoftware}, 0), (Order{0, 1}));
  EXPECT_EQ(eglOrder({kSurfaceless, nvidia(1), kSoftware}, 0), (Order{0, 1, 2}));
  EXPECT_EQ(eglOrder({kSurfaceless, kOtherVendor}, 3), (Order{0, 1}));
}

TEST(EglChoice, NoPlaceIsLeftOutForOneMayFail) {
  EXPECT_EQ(eglOrder({nvidia(0), nvidia(0), nvidia(0)}, 0), (Order{0, 1, 2}));
  EXPECT_EQ(eglOrder({}, 0), Order{});
}

TEST(EglChoice, AProcessorThatDrawsSaysSo) {
  EXPECT_TRUE(kSoftware.software());
  EXPECT_FALSE(nvidia(0).software());
  EXPECT_FALSE(kSurfaceless.software());
}

TEST(EglChoice, AProcessorThatDrawsIsKnownByItsName) {
  for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "llvmpipe (LLVM 19.1.7, 256 bits)", "softpipe",
                           "zink Vulkan 1.4(llvmpipe (LLVM 19.1.7, 256 bits) (MESA_LLVMPIPE))", "Software Rasterizer",
                           "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (LLVM 10.0.0)))"}) {
    EXPECT_TRUE(softwareRenderer(name)) << name;
  }
  for (const char* name : {"NVIDIA H200/PCIe/SSE2", "AMD Radeon RX 7900 XTX (radeonsi, navi31, LLVM 19.1.7, DRM 3.61)",
                           "Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "virgl (AMD Radeon Graphics)",
                           "zink Vulkan 1.4(NVIDIA GeForce RTX 4070 (NVIDIA_PROPRIETARY))", ""}) {
    EXPECT_FALSE(softwareRenderer(name)) << name;
  }
}

TEST(EglChoice, ExtensionsAreWholeWords) {
  EXPECT_TRUE(hasExtension("EGL_A EGL_B", "EGL_A"));
  EXPECT_TRUE(hasExtension("EGL_A EGL_B", "EGL_B"));
  EXPECT_TRUE(hasExtension("  EGL_A  EGL_B ", "EGL_B"));
  EXPECT_FALSE(hasExtension("EGL_EXT_device_drm_render_node", "EGL_EXT_device_drm"));
  EXPECT_FALSE(hasExtension("EGL_EXT_device_drm", "EGL_EXT_device_drm_render_node"));
  EXPECT_FALSE(hasExtension("", "EGL_A"));
}

}  // namespace
}  // namespace gw
