// Every probe on the cpu and on the cuda device, for each block size: the same words.
#include <stdexcept>

#include "gpu/exec/kernel_count.h"
#include "tests/gpu/parity_cases.h"
#include "tests/gpu/parity_fixture.h"
#include "tests/gpu/parity_sizes.h"

namespace gw::test {
namespace {

Probes probesOnCuda() {
#ifdef GW_HAVE_CUDA
  return cuda::probes();
#else
  throw std::logic_error("This build has no cuda device.");  // the fixture has skipped the test before
#endif
}

class PrimitivesParity : public ParityTest, public testing::WithParamInterface<size_t> {};

TEST_P(PrimitivesParity, BothDevicesAgree) {
  const ParityCase& which = parityCases()[GetParam()];
  const Words expected = which.run(cpu::probes(), {});
  ASSERT_FALSE(expected.empty());
  const uint64_t before = cudaKernelsRun;
  for (uint32_t blockSize : paritySizes().blockSizes) {
    ExecOptions options;
    options.blockSize = blockSize;
    const auto found = difference(expected, which.run(probesOnCuda(), options));
    EXPECT_FALSE(found) << *found << "; blocks of " << blockSize;
  }
  EXPECT_GT(cudaKernelsRun, before);
}

using KernelCount = ParityTest;

// What a captured sequence holds runs at every replay, and not when it is captured.
TEST_F(KernelCount, CountsWhatHasRun) {
  const uint64_t before = cudaKernelsRun;
  const std::vector<uint64_t> words(100, 1);
  probesOnCuda().replayGraph({}, words, 20);
  EXPECT_EQ(cudaKernelsRun - before, 60u);
  probesOnCuda().replayGraph({}, words, 0);
  EXPECT_EQ(cudaKernelsRun - before, 60u);
}

INSTANTIATE_TEST_SUITE_P(Cases, PrimitivesParity, testing::Range(size_t(0), parityCases().size()),
                         [](const auto& info) { return parityCases()[info.param].name; });

}  // namespace
}  // namespace gw::test
