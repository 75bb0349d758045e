// Nothing that kernels compute depends on the order of visits or on the number of threads: every case of
// parity_cases.h, in every order, against one thread that goes forward.
#include <gtest/gtest.h>

#include "tests/gpu/parity_cases.h"

namespace gw::test {
namespace {

class Order : public testing::TestWithParam<size_t> {};

TEST_P(Order, ChangesNoBit) {
  const Probes device = cpu::probes();
  const ParityCase& which = parityCases()[GetParam()];
  const Words expected = which.run(device, {1});
  ASSERT_FALSE(expected.empty());
  for (VisitOrder order : {VisitOrder::forward, VisitOrder::reversed, VisitOrder::shuffled}) {
    for (uint32_t threads : {1u, 2u, 7u}) {
      const auto found = difference(expected, which.run(device, {threads, order}));
      EXPECT_FALSE(found) << *found << "; order " << uint32_t(order) << ", " << threads << " threads";
    }
  }
}

TEST_P(Order, NeitherDoesProtectedMemory) {
  const Probes device = cpu::probes();
  const ParityCase& which = parityCases()[GetParam()];
  ExecOptions options{2};
  const Words expected = which.run(device, options);
  options.protectMemory = true;
  const auto found = difference(expected, which.run(device, options));
  EXPECT_FALSE(found) << *found;
}

INSTANTIATE_TEST_SUITE_P(Cases, Order, testing::Range(size_t(0), parityCases().size()),
                         [](const auto& info) { return parityCases()[info.param].name; });

TEST(Difference, SaysWhere) {
  EXPECT_EQ(difference({1, 2, 3}, {1, 2, 3}), std::nullopt);
  EXPECT_EQ(difference({1, 2, 3}, {1, 2, 4}), "word 2 of 3 is 4 instead of 3");
  EXPECT_EQ(difference({1, 2, 3}, {1, 2}), "2 words instead of 3");
}

}  // namespace
}  // namespace gw::test
