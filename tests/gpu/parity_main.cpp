// parity_test [--assets DIR] [--items N] [--enemies N] [--ticks N] [--first-tick N] [--block N]: both devices, bit for
// bit. All but the first make less of it (parity_sizes.h). The last line says how much really ran on a GPU.
#include <charconv>
#include <cstdio>
#include <optional>
#include <string_view>

#include "gpu/exec/kernel_count.h"
#include "tests/asset_folder.h"
#include "tests/gpu/parity_fixture.h"
#include "tests/gpu/parity_sizes.h"

namespace gw::test {
namespace {

std::filesystem::path folder;

std::optional<uint32_t> numberFrom(std::string_view text) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number == 0) return std::nullopt;
  return number;
}

bool takeOption(std::string_view name, std::string_view value) {
  if (name == "--assets") {
    folder = value;
    return true;
  }
  const std::optional<uint32_t> number = numberFrom(value);
  if (!number) return false;
  if (name == "--items") {
    paritySizes().items = *number;
  } else if (name == "--enemies") {
    paritySizes().enemies = *number;
  } else if (name == "--ticks") {
    paritySizes().ticks = *number;
  } else if (name == "--first-tick") {
    paritySizes().firstTick = *number;
  } else if (name == "--block") {
    paritySizes().blockSizes = {*number};
  } else {
    return false;
  }
  return true;
}

}  // namespace

const std::filesystem::path& assetFolder() {
  return folder;
}

}  // namespace gw::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  gw::test::folder = gw::findAssets(GW_ASSETS_DIR);
#ifdef GW_CUDA_STAND_IN
  gw::test::paritySizes().ticks = 200;  // fibers take their time
#endif
  for (int i = 1; i < argc; i += 2) {
    if (i + 1 == argc || !gw::test::takeOption(argv[i], argv[i + 1])) {
      std::fprintf(
          stderr,
          "usage: parity_test [--assets DIR] [--items N] [--enemies N] [--ticks N] [--first-tick N] [--block N]\n"
          "                   [--gtest_...]\n");
      return 2;
    }
  }
  const int status = RUN_ALL_TESTS();
  if (!testing::GTEST_FLAG(list_tests)) {
    std::printf("%llu CUDA kernels run\n", static_cast<unsigned long long>(gw::cudaKernelsRun.load()));
  }
  return status;
}
