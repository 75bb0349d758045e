#include "gpu/exec/guarded_memory.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "gpu/exec/buffer.h"

namespace gw {
namespace {

struct AddOne {
  uint32_t* words;
  void operator()(uint32_t i) const { ++words[i]; }
};

class GuardedMemoryDeathTest : public testing::Test {
 protected:
  void SetUp() override { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

TEST_F(GuardedMemoryDeathTest, HostCodeThatReadsOrWritesDies) {
  cpu::Queue queue({.threads = 2, .protectMemory = true});
  cpu::Buffer<uint32_t> buffer(queue, 5000);
  volatile uint32_t* words = buffer.data();
  EXPECT_DEATH({ [[maybe_unused]] const uint32_t word = words[0]; }, "");
  EXPECT_DEATH({ [[maybe_unused]] const uint32_t word = words[4999]; }, "");
  EXPECT_DEATH(words[0] = 1, "");
}

TEST_F(GuardedMemoryDeathTest, ItDiesAfterLaunchesAndCopiesToo) {
  cpu::Queue queue({.threads = 2, .protectMemory = true});
  cpu::Buffer<uint32_t> buffer(queue, 5000);
  cpu::forEach(queue, cpu::Count{5000}, AddOne{buffer.data()});
  ASSERT_EQ(buffer.download()[4999], 1u);
  volatile uint32_t* words = buffer.data();
  EXPECT_DEATH({ [[maybe_unused]] const uint32_t word = words[0]; }, "");
}

TEST(GuardedMemory, LaunchesAndCopiesMayUseIt) {
  cpu::Queue queue({.threads = 2, .protectMemory = true});
  cpu::Buffer<uint32_t> buffer(queue, 5000);
  buffer.upload(std::vector<uint32_t>(5000, 41));
  cpu::forEach(queue, cpu::Count{5000}, AddOne{buffer.data()});
  EXPECT_EQ(buffer.download(), std::vector<uint32_t>(5000, 42));
}

TEST(GuardedMemory, AccessOpensAllOfItAndNests) {
  GuardedMemory memory(true);
  auto* first = static_cast<uint8_t*>(memory.allocate(10));
  GuardedMemory::Access outer(memory);
  {
    GuardedMemory::Access inner(memory);
    first[0] = 1;
  }
  first[9] = 2;
  auto* second = static_cast<uint8_t*>(memory.allocate(10));  // made while open: open
  second[0] = 3;
  EXPECT_EQ(first[0] + first[9] + second[0], 6);
}

TEST(GuardedMemory, IsOpenWithoutProtection) {
  GuardedMemory memory(false);
  auto* bytes = static_cast<uint8_t*>(memory.allocate(1));
  bytes[0] = 7;
  EXPECT_EQ(bytes[0], 7);
}

TEST(GuardedMemory, ReleasedMemoryIsZeroWhenItComesBack) {
  GuardedMemory memory(false);
  for (int round = 0; round < 100; ++round) {
    auto* bytes = static_cast<uint8_t*>(memory.allocate(100000));
    for (size_t i = 0; i < 100000; i += 999) ASSERT_EQ(bytes[i], 0);
    std::memset(bytes, 0xAB, 100000);
    memory.release(bytes);
  }
}

TEST(GuardedMemory, ReleasingOneLeavesTheOthers) {
  GuardedMemory memory(false);
  auto* first = static_cast<uint8_t*>(memory.allocate(5000));
  auto* second = static_cast<uint8_t*>(memory.allocate(5000));
  auto* third = static_cast<uint8_t*>(memory.allocate(5000));
  first[4999] = 1;
  third[4999] = 3;
  memory.release(second);
  memory.release(nullptr);
  int nobodys = 0;
  memory.release(&nobodys);
  EXPECT_EQ(first[4999] + third[4999], 4);
}

TEST(GuardedMemory, IsPageAlignedAndNeverEmpty) {
  GuardedMemory memory(false);
  auto* none = static_cast<uint8_t*>(memory.allocate(0));
  EXPECT_EQ(uintptr_t(none) % 4096, 0u);
  none[0] = 1;
  EXPECT_EQ(uintptr_t(memory.allocate(4097)) % 4096, 0u);
}

TEST(GuardedMemory, SaysWhenTheMachineHasNoMore) {
  constexpr size_t kMost = std::numeric_limits<size_t>::max();
  for (size_t bytes : {size_t(1) << 50, size_t(1) << 60, kMost - 5000, kMost - 1, kMost}) {
    GuardedMemory memory(false);
    try {
      memory.allocate(bytes);
      ADD_FAILURE() << bytes << " bytes were granted";
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("The cpu device could not get "), std::string::npos) << text;
      EXPECT_NE(text.find("use fewer --enemies."), std::string::npos) << text;
    }
    // It goes on working.
    static_cast<uint8_t*>(memory.allocate(1))[0] = 1;
  }
}

}  // namespace
}  // namespace gw
