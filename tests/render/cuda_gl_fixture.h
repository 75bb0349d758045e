// Tests that draw what a CUDA device computes: on that device's own GPU where EGL offers it, elsewhere else; skipped
// where no CUDA device answers or nothing draws.
#pragma once

#include "gpu/devices/device_list.h"
#include "tests/render/gl_fixture.h"

namespace gw {

class CudaGlTest : public GlTest {
 protected:
  void SetUp() override {
    if (!listDevices().hasCuda()) GTEST_SKIP() << "no CUDA device";
    GlTest::SetUp();
  }

  std::optional<int> cudaDevice() const override { return currentCudaDevice(); }
};

}  // namespace gw
