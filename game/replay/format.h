// The constants of the replay format; docs/reference/replay-format.md describes the file in order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "game/sim/rules.h"

namespace gw {

// What the kernels play. Bump it in the commit that makes equal inputs give another game: replays of
// another version are then refused by name instead of failing as desyncs.
inline constexpr uint32_t kSimulationVersion = 3;

// What is written; 1.0 and 1.1 are read too.
inline constexpr uint16_t kReplayMajor = 2;  // older programs refuse a newer major...
inline constexpr uint16_t kReplayMinor = 0;  // ...and skip what a newer minor adds

inline constexpr uint32_t kMaxEnemies = 1'000'000;
inline constexpr uint32_t kMaxTicks = 4 * 60 * 60 * kTicksPerSecond;  // 4 h of game time
// The hashes by field are kept after every so many ticks: of each tick they would be five times the file.
inline constexpr uint32_t kFieldHashesEvery_ticks = 60;

namespace replay_format {

// The tail catches files that went through a text conversion, as in PNG.
inline constexpr std::array<uint8_t, 8> kMagic = {'G', 'W', 'R', 'P', '\r', '\n', 0x1a, '\n'};

inline constexpr size_t kMaxFileBytes = 64u << 20;
inline constexpr size_t kMaxChunkBytes = 1u << 20;  // as it is when inflated
inline constexpr size_t kMaxOptionsBytes = 4096;
inline constexpr size_t kHeaderBytes = 128;
inline constexpr size_t kChunkHeaderBytes = 32;
inline constexpr size_t kChunkHeaderBytes1 = 24;  // of major 1, which knows no compression
inline constexpr size_t kRunBytes = 12;           // one run of equal inputs
inline constexpr size_t kHashBytes = 8;           // one tick's hash
inline constexpr size_t kFinalBytes = 24;
inline constexpr size_t kEndBytes = 8;
// More fields than this program knows are read over; so many more that it costs nothing to look at.
inline constexpr uint32_t kMaxStoredFields = 64;

// A block is what INPT, HASH and FLDS chunks hold of the run, one after the other: a file that is cut has lost the
// block it was cut in and what follows. A minute in a whole file, a second in one that grows during play.
inline constexpr uint32_t kTicksPerBlock = 60 * kTicksPerSecond;
inline constexpr uint32_t kTicksPerGrowingBlock = kTicksPerSecond;
static_assert(kTicksPerBlock % kFieldHashesEvery_ticks == 0 && kTicksPerGrowingBlock % kFieldHashesEvery_ticks == 0);

// Offsets in the header; its last 8 bytes are the checksum of the 120 before.
inline constexpr size_t kOffsetMajor = 8;
inline constexpr size_t kOffsetMinor = 10;
inline constexpr size_t kOffsetHeaderBytes = 12;
inline constexpr size_t kOffsetSimulationVersion = 16;
inline constexpr size_t kOffsetSeed = 24;
inline constexpr size_t kOffsetMode = 32;
inline constexpr size_t kOffsetEnemies = 36;
inline constexpr size_t kOffsetAutopilot = 40;
inline constexpr size_t kOffsetTicks = 44;  // both 0: the file is growing, or its writer died
inline constexpr size_t kOffsetChunks = 48;
inline constexpr size_t kOffsetGather = 52;  // since 1.1; 0 before, which is what those runs had
inline constexpr size_t kOffsetSort = 56;
inline constexpr size_t kOffsetChecksum = 120;

constexpr uint32_t fourcc(char a, char b, char c, char d) {
  return uint32_t(uint8_t(a)) | uint32_t(uint8_t(b)) << 8 | uint32_t(uint8_t(c)) << 16 | uint32_t(uint8_t(d)) << 24;
}
inline constexpr uint32_t kOptionsChunk = fourcc('O', 'P', 'T', 'S');
inline constexpr uint32_t kTablesChunk = fourcc('T', 'A', 'B', 'L');
inline constexpr uint32_t kInputsChunk = fourcc('I', 'N', 'P', 'T');
inline constexpr uint32_t kHashesChunk = fourcc('H', 'A', 'S', 'H');
inline constexpr uint32_t kFieldHashesChunk = fourcc('F', 'L', 'D', 'S');
inline constexpr uint32_t kFinalChunk = fourcc('F', 'I', 'N', 'L');
inline constexpr uint32_t kEndChunk = fourcc('E', 'N', 'D', '!');

inline constexpr uint32_t kRequired = 1u << 0;  // a reader that does not know the chunk must refuse the file

}  // namespace replay_format
}  // namespace gw
