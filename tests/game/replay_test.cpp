// Replays survive the way through a file, byte for byte and field for field.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "game/replay/byte_order.h"
#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "tests/game/replay_samples.h"

namespace gw::test {
namespace {

using namespace replay_format;

bool sameContent(const Replay& a, const Replay& b) {
  return a.header == b.header && a.inputs == b.inputs && a.hashes == b.hashes && a.result == b.result &&
         a.rules.game.text == b.rules.game.text && a.rules.enemies.text == b.rules.enemies.text &&
         a.rules.waves.text == b.rules.waves.text;
}

Replay throughBytes(const Replay& replay) {
  return decodeReplay(encodeReplay(replay), "x.gwr");
}

size_t chunksOf(const Bytes& file, uint32_t kind) {
  size_t count = 0;
  for (const ForgedChunk& c : ForgedFile(file).chunks) count += c.kind == kind;
  return count;
}

TEST(Replay, SurvivesTheWayThroughBytes) {
  EXPECT_TRUE(sameContent(throughBytes(sampleReplay()), sampleReplay()));
}

TEST(Replay, NamesEmbeddedTablesAfterTheFile) {
  EXPECT_EQ(throughBytes(sampleReplay()).rules.waves.name, "waves.toml in x.gwr");
}

TEST(Replay, NeedsNoOptionsText) {
  Replay replay = sampleReplay();
  replay.header.options.clear();
  EXPECT_TRUE(sameContent(throughBytes(replay), replay));
}

TEST(Replay, KeepsHowTheRunEnded) {
  Replay replay = sampleReplay();
  EXPECT_TRUE(throughBytes(replay).result.over);
  replay.result.over = false;
  EXPECT_FALSE(throughBytes(replay).result.over);
}

// Files of format 1.0 have zeros where gather and sort stand now.
TEST(Replay, OlderFilesAreExact) {
  ForgedFile old(encodeReplay(sampleReplay()));
  old.setHeader16(kOffsetMinor, 0);
  old.setHeader32(kOffsetGather, 0);
  old.setHeader32(kOffsetSort, 0);
  const Replay replay = decodeReplay(old.seal(), "old.gwr");
  EXPECT_EQ(replay.header.gather, Gather::exact);
  EXPECT_EQ(replay.header.sort, Sort::bitonic);
}

TEST(Replay, EveryGatherAndSortThatGoTogetherSurvive) {
  for (const auto& [gather, sort] : {std::pair(Gather::exact, Sort::bitonic),
                                     {Gather::adaptive, Sort::bitonic},
                                     {Gather::adaptive, Sort::oddEven},
                                     {Gather::fixed, Sort::bitonic}}) {
    Replay replay = sampleReplay();
    replay.header.gather = gather;
    replay.header.sort = sort;
    EXPECT_TRUE(sameContent(throughBytes(replay), replay));
  }
}

RC_GTEST_PROP(Replay, SurvivesWhateverWasPlayed, ()) {
  const auto stick = rc::gen::inRange<int>(-kStickFull, kStickFull + 1);
  const auto runs = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::pair<uint32_t, uint32_t>>>(
      rc::gen::pair(rc::gen::inRange<uint32_t>(1, 300), rc::gen::inRange<uint32_t>(0, 4))));
  Replay replay = sampleReplay();
  replay.inputs.clear();
  replay.hashes.clear();
  std::vector<InputRecord> records;
  for (int i = 0; i < 4; ++i) {
    records.push_back({int16_t(*stick), int16_t(*stick), *rc::gen::arbitrary<uint16_t>(),
                       uint16_t(*rc::gen::arbitrary<uint16_t>() & kButtonsKnown)});
  }
  for (const auto& [length, which] : runs) {
    for (uint32_t i = 0; i < length; ++i) {
      replay.inputs.push_back(records[which]);
      replay.hashes.push_back(replay.inputs.size() * 0x9e3779b97f4a7c15);
    }
  }
  replay.header.seed = *rc::gen::arbitrary<uint64_t>();
  replay.header.enemies = *rc::gen::inRange<uint32_t>(1, kMaxEnemies + 1);
  replay.header.options = *rc::gen::arbitrary<std::string>();
  replay.rules.game.text = *rc::gen::arbitrary<std::string>();
  replay.result.score = *rc::gen::arbitrary<uint64_t>();
  RC_ASSERT(sameContent(throughBytes(replay), replay));
  RC_ASSERT(encodeReplay(throughBytes(replay)) == encodeReplay(replay));
}

TEST(Replay, EqualInputsTakeOneRun) {
  Replay replay = sampleReplay();
  const size_t before = encodeReplay(replay).size();
  replay.inputs.insert(replay.inputs.end(), 1000, replay.inputs.back());
  replay.hashes.insert(replay.hashes.end(), 1000, 1);
  EXPECT_EQ(encodeReplay(replay).size(), before + 1000 * kHashBytes);
}

// The longest run with an input that changes every tick: everything is split into chunks, all within limits.
TEST(Replay, HoldsFourHoursOfChangingInput) {
  Replay replay = sampleReplay();
  replay.inputs.clear();
  replay.hashes.clear();
  for (uint32_t i = 0; i < kMaxTicks; ++i) {
    replay.inputs.push_back({int16_t(i % 30000), 0, uint16_t(i), 0});
    replay.hashes.push_back(i);
  }
  const Bytes file = encodeReplay(replay);
  EXPECT_LT(file.size(), kMaxFileBytes);
  EXPECT_GT(chunksOf(file, kInputsChunk), 1u);
  EXPECT_GT(chunksOf(file, kHashesChunk), 1u);
  EXPECT_TRUE(sameContent(decodeReplay(file, "long.gwr"), replay));
}

TEST(Replay, LiesInTheFileAsDocumented) {
  const Bytes file = encodeReplay(sampleReplay());
  const Bytes start = {'G', 'W', 'R', 'P', '\r', '\n', 0x1a, '\n', 1, 0, 1, 0, 128, 0, 0, 0};
  EXPECT_EQ(Bytes(file.begin(), file.begin() + 16), start);
  EXPECT_EQ(getLittle<uint64_t>(file, 24), 0x0123456789abcdefu);
  EXPECT_EQ(getLittle<uint32_t>(file, 44), 12u);
  EXPECT_EQ(getLittle<uint32_t>(file, 52), 2u);  // fixed
  EXPECT_EQ(getLittle<uint32_t>(file, 56), 1u);  // odd-even
  EXPECT_EQ(std::string(file.begin() + 128, file.begin() + 132), "OPTS");
  EXPECT_EQ(std::string(file.end() - 32, file.end() - 28), "END!");
}

TEST(Replay, WriterRefusesWhatNoReaderTakes) {
  const auto refused = [](auto change) {
    Replay replay = sampleReplay();
    change(replay);
    EXPECT_THROW(encodeReplay(replay), std::invalid_argument);
  };
  refused([](Replay& r) { r.inputs.clear(), r.hashes.clear(); });
  refused([](Replay& r) { r.hashes.pop_back(); });
  refused([](Replay& r) { r.header.enemies = 0; });
  refused([](Replay& r) { r.header.enemies = kMaxEnemies + 1; });
  refused([](Replay& r) { r.header.mode = Mode(9); });
  refused([](Replay& r) { r.header.gather = Gather(3); });
  refused([](Replay& r) { r.header.sort = Sort(2); });
  refused([](Replay& r) { r.header.gather = Gather::exact; });  // with the sample's odd-even sort
  refused([](Replay& r) { r.header.options.assign(kMaxOptionsBytes + 1, 'x'); });
  refused([](Replay& r) { r.rules.waves.text.assign(kMaxRuleText + 1, '#'); });
  refused([](Replay& r) { r.inputs[3].move_x = -32768; });
  refused([](Replay& r) { r.inputs[3].buttons = 1u << 15; });
}

}  // namespace
}  // namespace gw::test
