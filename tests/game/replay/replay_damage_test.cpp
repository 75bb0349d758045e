// Nothing but an undamaged replay of this version is accepted, and no forged length makes the reader
// allocate.
#include <gtest/gtest.h>

#include "game/replay/byte_order.h"
#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "tests/game/replay/replay_allocation_watch.h"
#include "tests/game/replay/replay_samples.h"

namespace gw::test {
namespace {

using namespace replay_format;
using ::testing::TestWithParam;

const Bytes& sampleFile() {
  static const Bytes file = encodeReplay(sampleReplay());
  return file;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ReplayDamage, TheUndamagedFileIsAccepted) {
  EXPECT_EQ(refusalOf(sampleFile()), "");
}
TEST(ReplayDamage, ResealingWithoutChangeIsAccepted) {
  EXPECT_EQ(ForgedFile(sampleFile()).seal(), sampleFile());
}

TEST(ReplayDamage, EveryFlippedBitIsRefused) {
  Bytes file = sampleFile();
  for (size_t at = 0; at < file.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      file[at] ^= uint8_t(1u << bit);
      EXPECT_NE(refusalOf(file), "") << "byte " << at << ", bit " << bit;
      file[at] ^= uint8_t(1u << bit);
    }
  }
}

TEST(ReplayDamage, EveryOverwrittenByteIsRefused) {
  for (size_t at = 0; at < sampleFile().size(); ++at) {
    for (uint8_t value : {uint8_t(0x00), uint8_t(0xff), uint8_t(0x80), uint8_t(~sampleFile()[at])}) {
      Bytes file = sampleFile();
      if (file[at] == value) continue;
      file[at] = value;
      EXPECT_NE(refusalOf(file), "") << "byte " << at << " = " << int(value);
    }
  }
}

TEST(ReplayDamage, EveryTruncationIsRefused) {
  for (size_t length = 0; length < sampleFile().size(); ++length) {
    EXPECT_NE(refusalOf(Bytes(sampleFile().begin(), sampleFile().begin() + ptrdiff_t(length))), "") << length;
  }
}

TEST(ReplayDamage, TrailingBytesAreRefused) {
  Bytes file = sampleFile();
  file.push_back(0);
  EXPECT_TRUE(contains(refusalOf(file), "1 bytes follow its end")) << refusalOf(file);
  Bytes twice = sampleFile();
  twice.insert(twice.end(), sampleFile().begin(), sampleFile().end());
  EXPECT_NE(refusalOf(twice), "");
}

TEST(ReplayDamage, MissingEndIsRefused) {
  const Bytes file(sampleFile().begin(), sampleFile().end() - ptrdiff_t(kChunkHeaderBytes + kEndBytes));
  EXPECT_EQ(
      refusalOf(file),
      "x.gwr: the replay ends after tick 12 without its end mark; watch it with 'gpuwars replay x.gwr', or make it "
      "whole with 'gpuwars trim x.gwr --out NEW.gwr'");
}

TEST(ReplayDamage, ForeignFilesAreNamedAsSuch) {
  const std::string text = "[world]\nwidth_m = 192\n";
  EXPECT_TRUE(contains(refusalOf(Bytes(text.begin(), text.end())), "a text file, not a replay"));
  EXPECT_TRUE(contains(refusalOf({0x89, 'P', 'N', 'G', 0, 1, 2, 3}), "a file of another kind, not a replay"));
  EXPECT_TRUE(contains(refusalOf({}), "the file is empty"));
  Bytes converted = sampleFile();
  converted.erase(converted.begin() + 4);  // \r\n became \n
  EXPECT_TRUE(contains(refusalOf(converted), "converted as if it were text"));
}

TEST(ReplayDamage, NewerFormatIsRefusedByName) {
  ForgedFile file(sampleFile());
  file.setHeader16(kOffsetMajor, kReplayMajor + 1);
  EXPECT_TRUE(contains(refusalOf(file.seal()), "format 3.0, newer than this program's 2.0")) << refusalOf(file.seal());
}

TEST(ReplayDamage, NewerMinorIsAccepted) {
  ForgedFile file(sampleFile());
  file.setHeader16(kOffsetMinor, kReplayMinor + 1);
  EXPECT_EQ(refusalOf(file.seal()), "");
}

TEST(ReplayDamage, AnotherSimulationIsRefusedByNameUnlessAskedFor) {
  ForgedFile file(sampleFile());
  file.setHeader32(kOffsetSimulationVersion, kSimulationVersion + 40);
  const Bytes bytes = file.seal();
  EXPECT_TRUE(contains(refusalOf(bytes), "simulation version " + std::to_string(kSimulationVersion + 40)))
      << refusalOf(bytes);
  EXPECT_TRUE(contains(refusalOf(bytes), "tests/update_replays"));
  EXPECT_EQ(decodeReplay(bytes, "x.gwr", SimulationVersions::any).header.simulationVersion, kSimulationVersion + 40);
}

TEST(ReplayDamage, UnknownChunksAreSkippedWhenOptionalAndRefusedWhenRequired) {
  ForgedFile file(sampleFile());
  file.chunks.insert(file.chunks.begin() + 1, {fourcc('N', 'O', 'T', 'E'), 0, 7, {1, 2, 3}, 3});
  EXPECT_EQ(refusalOf(file.seal()), "");
  file.chunks[1].payload = Bytes(900, 7);  // what is not read is not inflated
  file.chunks[1].stored = Bytes{1, 2, 3};
  EXPECT_EQ(refusalOf(file.seal()), "");
  file.chunks[1].flags = kRequired;
  EXPECT_TRUE(contains(refusalOf(file.seal()), "needs chunk NOTE")) << refusalOf(file.seal());
}

// One forgery each: what it changes, and what the refusal says.
struct Forgery {
  const char* name;
  void (*change)(ForgedFile&);
  const char* says;
  bool countChunks = true;
};

const Forgery kForgeries[] = {
    {"HugeLength", [](ForgedFile& f) { f.chunk(kTablesChunk).claimedLength = 0xffffffff; }, "claims more than"},
    {"LargestLength", [](ForgedFile& f) { f.chunk(kTablesChunk).claimedLength = kMaxChunkBytes; }, "ends within chunk"},
    {"LongerStoredThanItIs", [](ForgedFile& f) { f.chunk(kTablesChunk).claimedStored = 1000; }, "longer stored than"},
    {"NotCompressed",
     [](ForgedFile& f) { f.chunk(kInputsChunk).claimedLength += 12, f.chunks[2].stored = Bytes(9, 3); },
     "cannot be inflated"},
    {"OverlappingLength", [](ForgedFile& f) { f.chunk(kInputsChunk).claimedLength += 24; }, "checksum of chunk INPT"},
    {"ShortLength", [](ForgedFile& f) { f.chunk(kInputsChunk).claimedLength -= 12; }, "checksum of chunk INPT"},
    {"ZeroLength",
     [](ForgedFile& f) {
       f.chunk(kHashesChunk) = {kHashesChunk, kRequired, 1, {}, 0};
     },
     "broken length"},
    {"LongTable", [](ForgedFile& f) { putLittleAt(f.chunk(kTablesChunk).payload, 0, 0xfffffff0u); },
     "longer than its chunk"},
    {"TablesFollowed",
     [](ForgedFile& f) {
       f.chunk(kTablesChunk).payload.push_back(0);
       ++f.chunk(kTablesChunk).claimedLength;
     },
     "followed by something else"},
    {"EmptyTables",
     [](ForgedFile& f) {
       f.chunk(kTablesChunk) = {kTablesChunk, kRequired, 0, {}, 0};
     },
     "end early"},
    {"LongRun", [](ForgedFile& f) { putLittleAt(f.chunk(kInputsChunk).payload, 0, 0xffffffffu); },
     "more inputs than ticks"},
    {"EmptyRun", [](ForgedFile& f) { putLittleAt(f.chunk(kInputsChunk).payload, 0, 0u); }, "more inputs than ticks"},
    {"ShortRun", [](ForgedFile& f) { putLittleAt(f.chunk(kInputsChunk).payload, 0, 1u); }, "inputs are missing"},
    {"StickOutOfRange", [](ForgedFile& f) { putLittleAt(f.chunk(kInputsChunk).payload, 4, uint16_t(0x8000)); },
     "input is out of range"},
    {"UnknownButton", [](ForgedFile& f) { putLittleAt(f.chunk(kInputsChunk).payload, 10, uint16_t(0x8000)); },
     "input is out of range"},
    {"Gap", [](ForgedFile& f) { f.chunk(kHashesChunk).firstTick = 2; }, "does not continue"},
    {"OverOutOfRange", [](ForgedFile& f) { putLittleAt(f.chunk(kFinalChunk).payload, 20, 2u); }, "out of range"},
    {"MoreTicks", [](ForgedFile& f) { f.setHeader32(kOffsetTicks, 13); }, "inputs are missing"},
    {"FewerTicks", [](ForgedFile& f) { f.setHeader32(kOffsetTicks, 11); }, "more inputs than ticks"},
    {"NoTicks", [](ForgedFile& f) { f.setHeader32(kOffsetTicks, 0); }, "number of ticks"},
    {"AbsurdTicks", [](ForgedFile& f) { f.setHeader32(kOffsetTicks, kMaxTicks + 1); }, "number of ticks"},
    {"TooManyTicks", [](ForgedFile& f) { f.setHeader32(kOffsetTicks, kMaxTicks); }, "inputs are missing"},
    {"ManyChunks", [](ForgedFile& f) { f.setHeader32(kOffsetChunks, 0xffffffff); }, "number of chunks", false},
    {"FewerChunks", [](ForgedFile& f) { f.setHeader32(kOffsetChunks, 5); }, "END! chunk is not where", false},
    {"NoChunks", [](ForgedFile& f) { f.setHeader32(kOffsetChunks, 0); }, "number of chunks", false},
    {"GrowingWithAnEnd", [](ForgedFile& f) { f.setHeader32(kOffsetChunks, 0), f.setHeader32(kOffsetTicks, 0); },
     "END! chunk is not where", false},
    {"FieldsOfNothing",
     [](ForgedFile& f) {
       f.chunks.push_back({kFieldHashesChunk, 0, 60, Bytes(4, 0), 4});
     },
     "number of fields"},
    {"FieldsWithoutTicks",
     [](ForgedFile& f) {
       Bytes payload(4 + kHashFields * kHashBytes);
       putLittleAt(payload, 0, kHashFields);
       f.chunks.push_back({kFieldHashesChunk, 0, 60, payload, uint32_t(payload.size())});
     },
     "more hashes by field than ticks"},
    {"UnknownMode", [](ForgedFile& f) { f.setHeader32(kOffsetMode, 4); }, "mode is unknown"},
    {"NoEnemies", [](ForgedFile& f) { f.setHeader32(kOffsetEnemies, 0); }, "number of enemies"},
    {"AbsurdEnemies", [](ForgedFile& f) { f.setHeader32(kOffsetEnemies, kMaxEnemies + 1); }, "number of enemies"},
    {"UnknownAutopilot", [](ForgedFile& f) { f.setHeader32(kOffsetAutopilot, 3); }, "autopilot is unknown"},
    {"UnknownGather", [](ForgedFile& f) { f.setHeader32(kOffsetGather, 3); }, "gather is unknown"},
    {"UnknownSort", [](ForgedFile& f) { f.setHeader32(kOffsetSort, 2); }, "sort is unknown"},
    {"ExactOddEven", [](ForgedFile& f) { f.setHeader32(kOffsetGather, 0); }, "gather and sort do not go together"},
    {"OtherHeaderLength", [](ForgedFile& f) { f.setHeader32(kOffsetHeaderBytes, 64); }, "another length"},
    {"FormatZero", [](ForgedFile& f) { f.setHeader16(kOffsetMajor, 0); }, "format 0.0"},
    {"UnknownFlags", [](ForgedFile& f) { f.chunk(kFinalChunk).flags = 3; }, "unknown flags"},
    {"OptionalInputs", [](ForgedFile& f) { f.chunk(kInputsChunk).flags = 0; }, "mislabelled"},
    {"TwoFinals", [](ForgedFile& f) { f.chunks.push_back(f.chunk(kFinalChunk)); }, "stands in it twice"},
    {"NoFinal", [](ForgedFile& f) { f.chunks.pop_back(); }, "final report is missing"},
    {"NoTables", [](ForgedFile& f) { f.chunks.erase(f.chunks.begin() + 1); }, "rule tables are missing"},
    {"NoHashes", [](ForgedFile& f) { f.chunks.erase(f.chunks.begin() + 3); }, "hashes are missing"},
    {"TwiceTheHashes", [](ForgedFile& f) { f.chunks.push_back(f.chunk(kHashesChunk)); }, "does not continue"},
    {"EarlyEnd",
     [](ForgedFile& f) {
       f.chunks.insert(f.chunks.begin(), {kEndChunk, kRequired, 0, Bytes(8, 0), 8});
     },
     "END! chunk is not where"},
};

class ReplayForgery : public TestWithParam<Forgery> {};

TEST_P(ReplayForgery, IsRefusedWithoutAllocating) {
  ForgedFile file(sampleFile());
  GetParam().change(file);
  const Bytes bytes = file.seal(GetParam().countChunks);
  watchAllocations();
  const std::string refusal = refusalOf(bytes);
  EXPECT_LT(largestAllocation(), 4096u);
  EXPECT_TRUE(contains(refusal, GetParam().says)) << refusal;
  EXPECT_EQ(refusal.rfind("x.gwr: ", 0), 0u) << refusal;
  EXPECT_TRUE(contains(refusal, ";")) << "no remedy: " << refusal;
}

INSTANTIATE_TEST_SUITE_P(Each, ReplayForgery, ::testing::ValuesIn(kForgeries),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gw::test
