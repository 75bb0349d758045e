// Every probe on the cpu and on the cuda device, for each block size: the same words.
#include <stdexcept>

#include "tests/gpu/parity_cases.h"
#include "tests/gpu/parity_fixture.h"

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
  for (uint32_t blockSize : {64u, 128u, 256u}) {
    ExecOptions options;
    options.blockSize = blockSize;
    const auto found = difference(expected, which.run(probesOnCuda(), options));
    EXPECT_FALSE(found) << *found << "; blocks of " << blockSize;
  }
  EXPECT_GT(cudaKernelsRun, before);
}

INSTANTIATE_TEST_SUITE_P(Cases, PrimitivesParity, testing::Range(size_t(0), parityCases().size()),
                         [](const auto& info) { return parityCases()[info.param].name; });

}  // namespace
}  // namespace gw::test
