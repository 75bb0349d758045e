// Files made to cost their reader much: small ones that inflate to a lot, with every checksum right.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "game/replay/byte_order.h"
#include "game/replay/deflate.h"
#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "tests/game/replay/replay_allocation_watch.h"
#include "tests/game/replay/replay_samples.h"

namespace gw::test {
namespace {

using namespace replay_format;

// Beyond the file itself; what docs/reference/replay-format.md and replay_reader.h promise.
constexpr size_t kMostAllocated = 32u << 20;

ForgedChunk compressed(uint32_t kind, uint32_t flags, uint32_t firstTick, const Bytes& payload) {
  return {kind, flags, firstTick, payload, uint32_t(payload.size()), deflated(payload)};
}

TEST(ReplayBomb, AStreamMayNotGiveMoreOrLessThanItsChunkSays) {
  for (const int more : {-1, +1, +1000}) {
    ForgedFile file(encodeReplay(sampleReplay()));
    ForgedChunk& tables = file.chunk(kTablesChunk);
    tables.payload.resize(500);
    tables.claimedLength = 500;
    tables.stored = deflated(Bytes(size_t(500 + more), 0));
    EXPECT_NE(refusalOf(file.seal()).find("chunk TABL cannot be inflated"), std::string::npos)
        << refusalOf(file.seal());
  }
}

TEST(ReplayBomb, NothingMayFollowAStream) {
  std::vector<uint8_t> raw;
  Bytes stream = deflated(Bytes(500, 0));
  EXPECT_TRUE(inflateExactly(raw, 500, stream));
  stream.push_back(0);
  EXPECT_FALSE(inflateExactly(raw, 500, stream));
  stream.resize(stream.size() - 2);  // and its own checksum may not be missing
  EXPECT_FALSE(inflateExactly(raw, 500, stream));
}

RC_GTEST_PROP(ReplayBomb, WhateverIsDeflatedInflates, ()) {
  Bytes raw = *rc::gen::arbitrary<Bytes>();
  const size_t repeats = *rc::gen::inRange<size_t>(1, 20);
  const Bytes once = raw;
  for (size_t i = 1; i < repeats; ++i) raw.insert(raw.end(), once.begin(), once.end());
  const Bytes stream = deflated(raw);
  RC_PRE(!stream.empty());
  RC_ASSERT(stream.size() < raw.size());
  std::vector<uint8_t> again;
  RC_ASSERT(inflateExactly(again, raw.size(), stream));
  RC_ASSERT(again == raw);
}

TEST(ReplayBomb, AMebibyteIsTheMostOfAChunk) {
  ForgedFile file(encodeReplay(sampleReplay()));
  file.chunk(kTablesChunk) = compressed(kTablesChunk, kRequired, 0, Bytes(kMaxChunkBytes, 0));
  const Bytes bytes = file.seal();
  watchAllocations();
  EXPECT_NE(refusalOf(bytes).find("followed by something else"), std::string::npos) << refusalOf(bytes);
  EXPECT_LE(largestAllocation(), kMaxChunkBytes);

  file.chunk(kTablesChunk) = compressed(kTablesChunk, kRequired, 0, Bytes(kMaxChunkBytes + 1, 0));
  EXPECT_NE(refusalOf(file.seal()).find("claims more than"), std::string::npos);
}

// Four hours in a few kilobytes, valid throughout: the most that a file can hold.
Bytes fourHoursOfNothing(uint32_t storedFields, uint32_t ticks) {
  ForgedFile file(encodeReplay(sampleReplay()));
  file.setHeader32(kOffsetTicks, kMaxTicks);
  const ForgedChunk final = file.chunk(kFinalChunk);
  file.chunks.resize(2);
  Bytes run(kRunBytes, 0);
  putLittleAt(run, 0, ticks);
  file.chunks.push_back({kInputsChunk, kRequired, 1, run, uint32_t(run.size())});
  for (uint32_t tick = 0; tick < ticks; tick += kMaxChunkBytes / kHashBytes) {
    const size_t bytes = std::min<size_t>(kMaxChunkBytes, (ticks - tick) * kHashBytes);
    file.chunks.push_back(compressed(kHashesChunk, kRequired, tick + 1, Bytes(bytes, 0)));
  }
  const uint32_t perChunk = (kMaxChunkBytes - 4) / (storedFields * kHashBytes);
  const uint32_t records = ticks / kFieldHashesEvery_ticks;
  for (uint32_t first = 0; first < records; first += perChunk) {
    Bytes payload(4 + std::min(perChunk, records - first) * storedFields * kHashBytes);
    putLittleAt(payload, 0, storedFields);
    file.chunks.push_back(compressed(kFieldHashesChunk, 0, (first + 1) * kFieldHashesEvery_ticks, payload));
  }
  file.chunks.push_back(final);
  return file.seal();
}

TEST(ReplayBomb, TheLongestRunInTheSmallestFileStaysWithinTheLimit) {
  for (const uint32_t fields : {kHashFields, kMaxStoredFields}) {
    const Bytes file = fourHoursOfNothing(fields, kMaxTicks);
    watchAllocations();
    const Replay replay = decodeReplay(file, "x.gwr");
    EXPECT_EQ(replay.ticks(), kMaxTicks);
    EXPECT_EQ(replay.fieldHashes.size(), kMaxTicks / kFieldHashesEvery_ticks);
    EXPECT_LE(peakAllocated(), kMostAllocated);
    RecordProperty("peakBytes", int(peakAllocated()));
    std::printf("%zu bytes of file, %zu allocated at most\n", file.size(), peakAllocated());
  }
}

TEST(ReplayBomb, MoreThanFourHoursAreRefused) {
  const Bytes file = fourHoursOfNothing(kHashFields, kMaxTicks + 60);
  watchAllocations();
  EXPECT_NE(refusalOf(file).find("more inputs than ticks"), std::string::npos) << refusalOf(file);
  EXPECT_LE(peakAllocated(), kMostAllocated);
}

TEST(ReplayBomb, MoreFieldsThanAllowedAreRefused) {
  EXPECT_NE(refusalOf(fourHoursOfNothing(kMaxStoredFields + 1, kMaxTicks)).find("number of fields"), std::string::npos);
}

// A later version's fields stand behind those that are known.
TEST(ReplayBomb, FieldsOfALaterVersionAreReadOver) {
  const Replay replay = longerReplay();
  ForgedFile file(encodeReplay(replay));
  ForgedChunk& chunk = file.chunk(kFieldHashesChunk);
  chunk.payload.clear();
  putLittle(chunk.payload, kHashFields + 2);
  for (const FieldHashes& fields : replay.fieldHashes) {
    for (const uint64_t hash : fields) putLittle(chunk.payload, hash);
    putLittle(chunk.payload, uint64_t(11));
    putLittle(chunk.payload, uint64_t(12));
  }
  chunk.claimedLength = uint32_t(chunk.payload.size());
  EXPECT_EQ(decodeReplay(file.seal(), "x.gwr").fieldHashes, replay.fieldHashes);
}

}  // namespace
}  // namespace gw::test
