#include "gpu/exec/buffer.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <stdexcept>

namespace gw::cpu {
namespace {

static_assert(!std::is_copy_constructible_v<Buffer<int>> && !std::is_copy_assignable_v<Buffer<int>>);
static_assert(std::is_nothrow_move_constructible_v<Buffer<int>> && std::is_nothrow_move_assignable_v<Buffer<int>>);

std::vector<uint32_t> counting(size_t count, uint32_t first = 0) {
  std::vector<uint32_t> words(count);
  std::iota(words.begin(), words.end(), first);
  return words;
}

TEST(Buffer, IsZeroAtBirth) {
  Queue queue({1});
  // What a released one held must not come back.
  for (int round = 0; round < 5; ++round) {
    Buffer<uint32_t> buffer(queue, 3000);
    EXPECT_EQ(buffer.download(), std::vector<uint32_t>(3000, 0));
    buffer.upload(counting(3000, 1));
  }
}

TEST(Buffer, BringsBackWhatWasUploaded) {
  Queue queue({1});
  for (size_t count : {0, 1, 1023, 1024, 1025, 100000}) {
    Buffer<uint32_t> buffer(queue, count);
    EXPECT_EQ(buffer.size(), count);
    buffer.upload(counting(count, 7));
    EXPECT_EQ(buffer.download(), counting(count, 7));
  }
}

TEST(Buffer, CopiesToAndFromAnOffset) {
  Queue queue({1});
  Buffer<uint32_t> buffer(queue, 100);
  buffer.upload(counting(100));
  const auto patch = counting(10, 1000);
  buffer.upload(patch.data(), patch.size(), 40);
  auto expected = counting(100);
  std::copy(patch.begin(), patch.end(), expected.begin() + 40);
  EXPECT_EQ(buffer.download(), expected);

  std::vector<uint32_t> part(20);
  buffer.download(part.data(), part.size(), 35);
  EXPECT_EQ(part, std::vector<uint32_t>(expected.begin() + 35, expected.begin() + 55));
  buffer.download(part.data(), 0, 100);
  buffer.upload(part.data(), 0, 100);
  EXPECT_EQ(buffer.download(), expected);
}

TEST(Buffer, MovesWithItsAddress) {
  Queue queue({1});
  Buffer<uint32_t> first(queue, 10);
  first.upload(counting(10, 3));
  uint32_t* const address = first.data();
  Buffer<uint32_t> second(std::move(first));
  EXPECT_EQ(second.data(), address);
  EXPECT_EQ(second.download(), counting(10, 3));
  Buffer<uint32_t> third;
  third = std::move(second);
  EXPECT_EQ(third.data(), address);
  EXPECT_EQ(third.size(), 10u);
  third = Buffer<uint32_t>(queue, 5);
  EXPECT_EQ(third.download(), std::vector<uint32_t>(5, 0));
}

TEST(Buffer, AnEmptyOneHoldsNothing) {
  const Buffer<uint32_t> buffer;
  EXPECT_EQ(buffer.data(), nullptr);
  EXPECT_EQ(buffer.size(), 0u);
}

TEST(Buffer, CopiesWithinTheDevice) {
  Queue queue({.threads = 1, .protectMemory = true});
  Buffer<uint32_t> from(queue, 1000), to(queue, 1000);
  from.upload(counting(1000, 5));
  copyBytes(queue, to.data() + 10, from.data(), 100 * sizeof(uint32_t), Copy::onDevice);
  auto expected = std::vector<uint32_t>(1000, 0);
  std::iota(expected.begin() + 10, expected.begin() + 110, 5u);
  EXPECT_EQ(to.download(), expected);
}

TEST(Buffer, RefusesWhatNoMachineHas) {
  Queue queue({1});
  EXPECT_THROW(Buffer<uint64_t>(queue, size_t(1) << 57), std::runtime_error);
}

}  // namespace
}  // namespace gw::cpu
