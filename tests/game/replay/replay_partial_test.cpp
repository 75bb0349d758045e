// What is left of a replay: every bit flipped and every length cut, of whole files and of growing ones. It is refused,
// or played up to where it is certain; never read as whole, and never read as another run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "game/replay/byte_order.h"
#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "tests/game/replay/replay_allocation_watch.h"
#include "tests/game/replay/replay_samples.h"

namespace gw::test {
namespace {

using namespace replay_format;

struct Kind {
  const char* name;
  Bytes (*file)();
  bool whole;
};
const Kind kKinds[] = {
    {"Format2", [] { return encodeReplay(longerReplay()); }, true},
    {"Format1", [] { return format1(longerReplay()); }, true},
    {"Growing", [] { return growingFile(longerReplay()); }, false},
};

// What a file still gave: nothing, or the ticks of the beginning of the run.
struct Reading {
  bool refused = true, whole = false;
  uint32_t ticks = 0;
};

template <typename T>
bool beginsWith(const std::vector<T>& all, const std::vector<T>& start) {
  return start.size() <= all.size() && std::equal(start.begin(), start.end(), all.begin());
}

Reading read(const Bytes& bytes, Completeness completeness) {
  try {
    const Replay replay = decodeReplay(bytes, "x.gwr", SimulationVersions::current, completeness);
    const Replay wanted = longerReplay();
    EXPECT_TRUE(beginsWith(wanted.inputs, replay.inputs) && beginsWith(wanted.hashes, replay.hashes) &&
                beginsWith(wanted.fieldHashes, replay.fieldHashes))
        << "another run was read";
    EXPECT_EQ(replay.inputs.size(), replay.hashes.size());
    return {false, replay.whole, replay.ticks()};
  } catch (const ReplayError& error) {
    EXPECT_NE(std::string(error.what()).find(';'), std::string::npos) << "no remedy: " << error.what();
    return {};
  }
}

class ReplayPartial : public ::testing::TestWithParam<Kind> {};

TEST_P(ReplayPartial, TheUntouchedFileIsReadAsWhatItIs) {
  const Bytes file = GetParam().file();
  const Reading tolerant = read(file, Completeness::partial);
  EXPECT_FALSE(tolerant.refused);
  EXPECT_EQ(tolerant.whole, GetParam().whole);
  EXPECT_EQ(tolerant.ticks, GetParam().whole ? 150u : 120u);  // a growing file has the full seconds
  EXPECT_EQ(read(file, Completeness::whole).refused, !GetParam().whole);
}

TEST_P(ReplayPartial, EveryFlippedBitIsRefusedOrEndsTheRunThere) {
  Bytes file = GetParam().file();
  uint32_t flips = 0, refused = 0, partial = 0;
  watchAllocations();
  for (size_t at = 0; at < file.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      file[at] ^= uint8_t(1u << bit);
      EXPECT_TRUE(read(file, Completeness::whole).refused) << "byte " << at << ", bit " << bit;
      const Reading reading = read(file, Completeness::partial);
      EXPECT_FALSE(reading.whole) << "byte " << at << ", bit " << bit;
      ++flips;
      ++(reading.refused ? refused : partial);
      file[at] ^= uint8_t(1u << bit);
    }
  }
  EXPECT_LT(peakAllocated(), 2u << 20);
  std::printf("%s: %u flips, none read as whole; %u refused, %u played as partial\n", GetParam().name, flips, refused,
              partial);
  EXPECT_EQ(flips, 8 * file.size());
  EXPECT_GT(refused, 9 * partial) << "damage is to be told from a cut";
}

// A file gives the ticks of those blocks that are whole in it, at each of its lengths.
TEST_P(ReplayPartial, EveryCutLeavesTheBlocksBeforeIt) {
  const Bytes file = GetParam().file();
  const ForgedFile parts(file);
  const std::vector<size_t> ends = parts.ends();
  uint32_t refused = 0, partial = 0;
  for (size_t length = 0; length < file.size(); ++length) {
    uint32_t inputs = 0, hashes = 0;
    for (size_t i = 0; i < ends.size() && ends[i] <= length; ++i) {
      const ForgedChunk& c = parts.chunks[i];
      for (size_t at = 0; c.kind == kInputsChunk && at < c.payload.size(); at += kRunBytes) {
        inputs += getLittle<uint32_t>(c.payload, at);
      }
      if (c.kind == kHashesChunk) hashes += uint32_t(c.payload.size() / kHashBytes);
    }
    const uint32_t ticks = std::min(inputs, hashes);
    const Bytes cut(file.begin(), file.begin() + ptrdiff_t(length));
    EXPECT_TRUE(read(cut, Completeness::whole).refused) << length;
    const Reading reading = read(cut, Completeness::partial);
    EXPECT_EQ(reading.refused, ticks == 0) << length;
    EXPECT_EQ(reading.ticks, ticks) << length;
    EXPECT_FALSE(reading.whole) << length;
    ++(reading.refused ? refused : partial);
  }
  std::printf("%s: %zu lengths; %u refused, %u played as partial\n", GetParam().name, file.size(), refused, partial);
  EXPECT_GT(partial, 0u);
}

INSTANTIATE_TEST_SUITE_P(Each, ReplayPartial, ::testing::ValuesIn(kKinds),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(ReplayPartialFiles, ATailOfZerosIsACut) {
  for (const Kind& kind : kKinds) {
    const Bytes file = kind.file();
    for (size_t kept = file.size() * 9 / 10; kept < file.size(); ++kept) {
      Bytes zeroed = file;
      std::fill(zeroed.begin() + ptrdiff_t(kept), zeroed.end(), uint8_t(0));
      if (zeroed == file) continue;
      EXPECT_TRUE(read(zeroed, Completeness::whole).refused) << kind.name << kept;
      EXPECT_FALSE(read(zeroed, Completeness::partial).whole) << kind.name << kept;
    }
  }
  Bytes growing = growingFile(longerReplay());
  const Reading before = read(growing, Completeness::partial);
  growing.resize(growing.size() + 4096, 0);
  EXPECT_EQ(read(growing, Completeness::partial).ticks, before.ticks);
}

TEST(ReplayPartialFiles, AreRefusedByWhoeverNeedsTheEnd) {
  EXPECT_EQ(refusalOf(growingFile(longerReplay())),
            "x.gwr: the replay ends after tick 120 without its end mark; watch it with 'gpuwars replay x.gwr', or make "
            "it whole with 'gpuwars trim x.gwr --out NEW.gwr'");
  const Bytes file = growingFile(longerReplay());
  const Bytes start(file.begin(), file.begin() + 400);
  EXPECT_EQ(refusalOf(start),
            "x.gwr: the recording was cut short within its first second, and nothing can be played; delete the file");
}

TEST(ReplayPartialFiles, HaveNoResult) {
  const Bytes file = encodeReplay(longerReplay());
  const Bytes cut(file.begin(), file.end() - 1);
  const Replay replay = decodeReplay(cut, "x.gwr", SimulationVersions::current, Completeness::partial);
  EXPECT_EQ(replay.ticks(), 150u);
  EXPECT_EQ(replay.result, FinalReport{});
  EXPECT_THROW(encodeReplay(replay), std::invalid_argument);
}

}  // namespace
}  // namespace gw::test
