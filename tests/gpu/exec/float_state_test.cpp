#include "gpu/exec/float_state.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <thread>

#include "tests/gpu/exec/float_bits.h"

namespace gw {
namespace {

using test::FloatBits;

class FloatState : public testing::Test {
 protected:
  void SetUp() override { setFloatState(); }
  void TearDown() override { setFloatState(); }
};

TEST_F(FloatState, IsTheDefaultOnceItIsSet) {
  EXPECT_TRUE(floatStateIsDefault());
  EXPECT_TRUE(setFloatState());
  EXPECT_TRUE(test::roundsToNearestEven());
  EXPECT_FALSE(test::flushesSubnormals());
}

TEST_F(FloatState, EachChangeIsNoticedAndUndone) {
  for (const FloatBits bits : test::kAllFloatBits) {
    test::addFloatBits(bits);
    EXPECT_FALSE(floatStateIsDefault()) << std::hex << uint64_t(bits);
    EXPECT_FALSE(setFloatState());
    EXPECT_TRUE(floatStateIsDefault());
    EXPECT_TRUE(setFloatState());
    EXPECT_TRUE(test::roundsToNearestEven());
    EXPECT_FALSE(test::flushesSubnormals());
  }
}

// The tests' own instruments: else what they say of the default state would prove nothing.
TEST_F(FloatState, ChangesAreFelt) {
  for (const FloatBits bits : {FloatBits::up, FloatBits::down, FloatBits::zero}) {
    test::addFloatBits(bits);
    EXPECT_FALSE(test::roundsToNearestEven()) << std::hex << uint64_t(bits);
    setFloatState();
  }
  test::addFloatBits(FloatBits::flush);
  EXPECT_TRUE(test::flushesSubnormals());
}

// fesetround() also changes what strtod() and printf() round by, which on x86-64 is another register.
TEST_F(FloatState, ReadingNumbersRoundsToNearestAgain) {
  const double nearest = std::strtod("0.1", nullptr);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    EXPECT_FALSE(setFloatState());
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
    EXPECT_EQ(std::strtod("0.1", nullptr), nearest);
  }
#if defined(__x86_64__)
  const uint16_t upwards = 0x0b7f;
  asm volatile("fldcw %0" : : "m"(upwards));  // MXCSR says nothing of it
  EXPECT_FALSE(floatStateIsDefault());
  EXPECT_FALSE(setFloatState());
  EXPECT_TRUE(floatStateIsDefault());
#endif
}

TEST_F(FloatState, PastExceptionsAreNoChange) {
  volatile float zero = 0.0f;
  volatile float infinite = 1.0f / zero;
  EXPECT_GT(infinite, 1.0f);
  EXPECT_TRUE(floatStateIsDefault());
  EXPECT_TRUE(setFloatState());
}

TEST_F(FloatState, IsOfOneThread) {
  test::addFloatBits(FloatBits::zero);
  bool inherited = false, setThere = false;
  std::thread([&] {
    inherited = !floatStateIsDefault();
    setFloatState();
    setThere = floatStateIsDefault();
  }).join();
  EXPECT_TRUE(inherited) << "so every thread has to set its own";
  EXPECT_TRUE(setThere);
  EXPECT_FALSE(floatStateIsDefault());
}

}  // namespace
}  // namespace gw
