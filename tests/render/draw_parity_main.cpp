// draw_parity_gl_test: the last line says how many kernels ran on a GPU for it.
#include <gtest/gtest.h>

#include <cstdio>

#include "gpu/exec/kernel_count.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int status = RUN_ALL_TESTS();
  if (!testing::GTEST_FLAG(list_tests)) {
    std::printf("%llu CUDA kernels run\n", static_cast<unsigned long long>(gw::cudaKernelsRun.load()));
  }
  return status;
}
