// The options of every verb that runs a simulation, and what they refuse.
#include <gtest/gtest.h>

#include "tests/game/cli/command_line_samples.h"

namespace gw::test {
namespace {

TEST(ComputingOptions, BlocksAreWholeWarps) {
  EXPECT_FALSE(accepted<PlayOptions>("").cudaCheck);
  EXPECT_TRUE(accepted<PlayOptions>("--headless --ticks 1 --cuda-check").cudaCheck);
  EXPECT_EQ(accepted<PlayOptions>("").blockSize, 128u);
  for (const uint32_t size : {32u, 64u, 256u, 1024u}) {
    EXPECT_EQ(accepted<VerifyOptions>("verify a --block-size " + std::to_string(size)).blockSize, size);
  }
}

TEST(ComputingOptions, TakesGatherAndSort) {
  const PlayOptions none = accepted<PlayOptions>("");
  EXPECT_FALSE(none.gather || none.sort);
  const PlayOptions both = accepted<PlayOptions>("--gather fixed --sort odd-even");
  EXPECT_EQ(both.gather, Gather::fixed);
  EXPECT_EQ(both.sort, Sort::oddEven);
  EXPECT_EQ(accepted<PlayOptions>("--gather adaptive --broad-phase ngrid").gather, Gather::adaptive);
  EXPECT_EQ(accepted<PlayOptions>("--gather exact --broad-phase brute").gather, Gather::exact);
  EXPECT_EQ(accepted<PlayOptions>("--broad-phase grid").broadPhase, BroadPhase::grid);
  EXPECT_EQ(accepted<PlayOptions>("--broad-phase grid-hashed").broadPhase, BroadPhase::gridHashed);
  // What the file holds is not known yet.
  EXPECT_EQ(accepted<VerifyOptions>("verify a --sort odd-even").sort, Sort::oddEven);
}

TEST(ComputingOptions, ThesisIsShorthand) {
  const auto check = [](const ComputingOptions& o, const char* line) {
    EXPECT_TRUE(o.thesis) << line;
    EXPECT_EQ(o.gather, Gather::adaptive) << line;
    EXPECT_EQ(o.sort, Sort::bitonic) << line;
  };
  for (const char* line : {"--thesis", "--thesis --gather adaptive", "--sort bitonic --thesis"}) {
    check(accepted<PlayOptions>(line), line);
  }
  check(accepted<VerifyOptions>("verify a --thesis"), "verify a --thesis");
}

INSTANTIATE_TEST_SUITE_P(
    Computing, CommandLineRefusal,
    ::testing::ValuesIn(std::vector<Refusal>{
        {"--gather adaptive --sort full",
         "'--sort full' does not keep the order that '--gather adaptive' needs; choose '--sort bitonic' or '--sort "
         "odd-even'"},
        {"--gather fixed --sort frozen",
         "'--sort frozen' does not keep the order that '--gather fixed' needs; choose '--sort bitonic' or '--sort "
         "odd-even'"},
        {"--sort frozen --broad-phase grid",
         "'--sort frozen' is about the NGrid, which '--broad-phase grid' does not use; leave out one of the two"},
        {"--device gpu", "'--device gpu' is not known; choose auto|cuda|cpu"},
        {"--broad-phase tree", "'--broad-phase tree' is not known; choose ngrid|grid|grid-hashed|brute"},
        {"--order random", "'--order random' is not known; choose forward|reversed|shuffled"},
        {"--threads 257", "'--threads 257' is not valid; give a whole number from 0 to 256"},
        {"--gather none", "'--gather none' is not known; choose exact|adaptive|fixed"},
        {"--sort quick", "'--sort quick' is not known; choose bitonic|odd-even|full|frozen"},
        {"--sort odd-even",
         "'--sort odd-even' does not keep the order that an exact gather needs; add '--gather adaptive' or '--gather "
         "fixed'"},
        {"verify a --gather exact --sort odd-even",
         "'--sort odd-even' does not keep the order that an exact gather needs; add '--gather adaptive' or '--gather "
         "fixed'"},
        {"--gather fixed --broad-phase brute",
         "'--gather fixed' is about the NGrid, which '--broad-phase brute' does not use; leave out one of the two"},
        {"--gather adaptive --broad-phase grid-hashed",
         "'--gather adaptive' is about the NGrid, which '--broad-phase grid-hashed' does not use; leave out one of the "
         "two"},
        {"verify a --thesis --broad-phase brute",
         "'--thesis' is about the NGrid, which '--broad-phase brute' does not use; leave out one of the two"},
        {"--thesis --gather fixed",
         "'--thesis' means '--gather adaptive --sort bitonic'; leave it or '--gather fixed' out"},
        {"--thesis --gather exact",
         "'--thesis' means '--gather adaptive --sort bitonic'; leave it or '--gather exact' out"},
        {"replay a --sort odd-even --thesis",
         "'--thesis' means '--gather adaptive --sort bitonic'; leave it or '--sort odd-even' out"},
        {"--block-size 31", "'--block-size 31' is not valid; give a whole number from 32 to 1,024"},
        {"--block-size 1056", "'--block-size 1056' is not valid; give a whole number from 32 to 1,024"},
        {"verify a --block-size 100", "'--block-size 100' is not valid; give a multiple of 32 from 32 to 1,024"},
        {"--device cpu --cuda-check",
         "'--cuda-check' is about the cuda device; leave it out or choose '--device cuda'"},
        {"--device cpu --block-size 64",
         "'--block-size' is about the cuda device; leave it out or choose '--device cuda'"},
        {"--device cuda --order reversed", "'--order' is about the cpu device; leave it out or choose '--device cpu'"},
        {"--device cuda --protect-memory",
         "'--protect-memory' is about the cpu device; leave it out or choose '--device cpu'"},
    }));

}  // namespace
}  // namespace gw::test
