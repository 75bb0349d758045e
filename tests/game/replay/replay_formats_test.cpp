// Files that released formats left behind stay readable. That they are still the same games is for 'gpuwars verify':
// replay_formats in tests/CMakeLists.txt.
#include <gtest/gtest.h>

#include <fstream>

#include "game/replay/byte_order.h"
#include "game/replay/replay_reader.h"

namespace gw::test {
namespace {

struct Kept {
  const char* name;
  uint16_t major;
  uint32_t ticks;
  size_t fieldHashes;
  FinalReport result;
};

class ReplayFormats : public ::testing::TestWithParam<Kept> {};

TEST_P(ReplayFormats, StayReadable) {
  const Kept& kept = GetParam();
  const std::filesystem::path path = std::filesystem::path(GW_FORMATS_DIR) / kept.name;
  std::ifstream file(path, std::ios::binary);
  std::vector<uint8_t> start(16);
  file.read(reinterpret_cast<char*>(start.data()), 16);
  ASSERT_TRUE(file) << path;
  EXPECT_EQ(getLittle<uint16_t>(start, replay_format::kOffsetMajor), kept.major);
  const Replay replay = readReplay(path);
  EXPECT_TRUE(replay.whole);
  EXPECT_EQ(replay.ticks(), kept.ticks);
  EXPECT_EQ(replay.fieldHashes.size(), kept.fieldHashes);
  EXPECT_EQ(replay.result, kept.result);
  EXPECT_EQ(replay.header.autopilot, Autopilot::expert);
  for (size_t k = 0; k < replay.fieldHashes.size(); ++k) {
    uint64_t sum = 0;
    for (const uint64_t hash : replay.fieldHashes[k]) sum += hash;
    EXPECT_EQ(sum, replay.hashes[(k + 1) * kFieldHashesEvery_ticks - 1]) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ReplayFormats,
                         ::testing::Values(Kept{"format_1.gwr", 1, 1800, 0, {112050, 154, 16667, false}},
                                           Kept{"format_2.gwr", 2, 200, 3, {209, 16, 16667, false}}),
                         [](const auto& info) { return "Major" + std::to_string(info.param.major); });

}  // namespace
}  // namespace gw::test
