// parity_test [--assets DIR]: both devices, bit for bit. The last line says how much really ran on a GPU.
#include <cstdio>
#include <string_view>

#include "gpu/exec/kernel_count.h"
#include "tests/asset_folder.h"
#include "tests/gpu/parity_fixture.h"

namespace gw::test {
namespace {

std::filesystem::path folder;

}  // namespace

const std::filesystem::path& assetFolder() {
  return folder;
}

}  // namespace gw::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  gw::test::folder = gw::findAssets(GW_ASSETS_DIR);
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) != "--assets" || i + 1 == argc) {
      std::fprintf(stderr, "usage: parity_test [--assets DIR] [--gtest_...]\n");
      return 2;
    }
    gw::test::folder = argv[++i];
  }
  const int status = RUN_ALL_TESTS();
  if (!testing::GTEST_FLAG(list_tests)) {
    std::printf("%llu CUDA kernels run\n", static_cast<unsigned long long>(gw::cudaKernelsRun.load()));
  }
  return status;
}
