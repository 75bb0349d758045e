// Replays survive the way through a file, byte for byte and field for field.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "game/replay/byte_order.h"
#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "tests/game/replay/replay_samples.h"

namespace gw::test {
namespace {

using namespace replay_format;

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
  EXPECT_TRUE(sameContent(throughBytes(longerReplay()), longerReplay()));
  EXPECT_TRUE(throughBytes(longerReplay()).whole);
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
  ForgedFile old(format1(sampleReplay()));
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

TEST(Replay, FilesOfFormat1AreRead) {
  Replay replay = longerReplay();
  const Bytes file = format1(replay);
  const Bytes start = {'G', 'W', 'R', 'P', '\r', '\n', 0x1a, '\n', 1, 0, 1, 0};
  EXPECT_EQ(Bytes(file.begin(), file.begin() + 12), start);
  replay.fieldHashes.clear();  // it had none
  EXPECT_TRUE(sameContent(decodeReplay(file, "old.gwr"), replay));
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
  if (*rc::gen::arbitrary<bool>()) {
    replay.fieldHashes.resize(replay.inputs.size() / kFieldHashesEvery_ticks);
    for (FieldHashes& fields : replay.fieldHashes) fields = *rc::gen::arbitrary<FieldHashes>();
  }
  replay.header.seed = *rc::gen::arbitrary<uint64_t>();
  replay.header.mode = Mode(*rc::gen::inRange<uint32_t>(0, 4));
  replay.header.autopilot = Autopilot(*rc::gen::inRange<uint32_t>(0, 3));
  replay.header.enemies = *rc::gen::inRange<uint32_t>(1, kMaxEnemies + 1);
  replay.header.options = *rc::gen::arbitrary<std::string>();
  replay.rules.game.text = *rc::gen::arbitrary<std::string>();
  replay.rules.waves.text = std::string(*rc::gen::inRange<size_t>(0, 4096), *rc::gen::arbitrary<char>());
  replay.result.score = *rc::gen::arbitrary<uint64_t>();
  RC_ASSERT(sameContent(throughBytes(replay), replay));
  RC_ASSERT(encodeReplay(throughBytes(replay)) == encodeReplay(replay));
}

TEST(Replay, EqualInputsTakeOneRun) {
  Replay replay = sampleReplay();
  const size_t before = ForgedFile(encodeReplay(replay)).chunk(kInputsChunk).payload.size();
  replay.inputs.insert(replay.inputs.end(), 1000, replay.inputs.back());
  replay.hashes.insert(replay.hashes.end(), 1000, 1);
  EXPECT_EQ(ForgedFile(encodeReplay(replay)).chunk(kInputsChunk).payload.size(), before);
}

// A minute each, so that a cut costs no more.
TEST(Replay, LiesInBlocksOfTicks) {
  Replay replay = longerReplay();
  while (replay.inputs.size() < 2 * kTicksPerBlock + 1) {
    replay.inputs.push_back({});
    replay.hashes.push_back(replay.inputs.size());
  }
  replay.fieldHashes.resize(replay.inputs.size() / kFieldHashesEvery_ticks);
  std::string order;
  for (const ForgedChunk& c : ForgedFile(encodeReplay(replay)).chunks) order += char(c.kind);
  EXPECT_EQ(order, "OTIHFIHFIHF");  // the last block has no hashes by field, so the last F is FINL
}

TEST(Replay, CompressesWhatGetsSmallerByIt) {
  const ForgedFile file(encodeReplay(longerReplay()));
  for (const ForgedChunk& c : file.chunks) {
    const bool compressible = c.kind == kOptionsChunk || c.kind == kTablesChunk || c.kind == kInputsChunk;
    EXPECT_EQ(c.stored.has_value(), compressible) << c.kind;
    if (c.stored) {
      EXPECT_LT(c.stored->size(), c.payload.size());
    }
  }
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
  const Bytes start = {'G', 'W', 'R', 'P', '\r', '\n', 0x1a, '\n', 2, 0, 0, 0, 128, 0, 0, 0};
  EXPECT_EQ(Bytes(file.begin(), file.begin() + 16), start);
  EXPECT_EQ(getLittle<uint64_t>(file, 24), 0x0123456789abcdefu);
  EXPECT_EQ(getLittle<uint32_t>(file, 44), 12u);
  EXPECT_EQ(getLittle<uint32_t>(file, 52), 2u);  // fixed
  EXPECT_EQ(getLittle<uint32_t>(file, 56), 1u);  // odd-even
  EXPECT_EQ(std::string(file.begin() + 128, file.begin() + 132), "OPTS");
  EXPECT_EQ(getLittle<uint32_t>(file, 136), 19u);  // raw...
  EXPECT_EQ(getLittle<uint32_t>(file, 140), 19u);  // ...and stored length of the options
  EXPECT_EQ(std::string(file.begin() + 160, file.begin() + 179), "--seed 7 --headless");
  EXPECT_EQ(std::string(file.end() - 40, file.end() - 36), "END!");
}

TEST(Replay, WriterRefusesWhatNoReaderTakes) {
  const auto refused = [](auto change) {
    Replay replay = sampleReplay();
    change(replay);
    EXPECT_THROW(encodeReplay(replay), std::invalid_argument);
  };
  refused([](Replay& r) { r.inputs.clear(), r.hashes.clear(); });
  refused([](Replay& r) { r.hashes.pop_back(); });
  refused([](Replay& r) { r.fieldHashes.resize(1); });  // twelve ticks have none
  refused([](Replay& r) { r.whole = false; });
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
