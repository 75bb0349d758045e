#include "game/replay/replay_parts.h"

#include <algorithm>

#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"
#include "game/replay/deflate.h"

namespace gw {

using namespace replay_format;
using Bytes = std::vector<uint8_t>;

void putReplayHeader(Bytes& bytes, const ReplayHeader& header, uint32_t ticks, uint32_t chunks) {
  Bytes head(kHeaderBytes, 0);
  std::copy(kMagic.begin(), kMagic.end(), head.begin());
  putLittleAt(head, kOffsetMajor, kReplayMajor);
  putLittleAt(head, kOffsetMinor, kReplayMinor);
  putLittleAt(head, kOffsetHeaderBytes, uint32_t(kHeaderBytes));
  putLittleAt(head, kOffsetSimulationVersion, header.simulationVersion);
  putLittleAt(head, kOffsetSeed, header.seed);
  putLittleAt(head, kOffsetMode, uint32_t(header.mode));
  putLittleAt(head, kOffsetEnemies, header.enemies);
  putLittleAt(head, kOffsetAutopilot, uint32_t(header.autopilot));
  putLittleAt(head, kOffsetTicks, ticks);
  putLittleAt(head, kOffsetChunks, chunks);
  putLittleAt(head, kOffsetGather, uint32_t(header.gather));
  putLittleAt(head, kOffsetSort, uint32_t(header.sort));
  putLittleAt(head, kOffsetChecksum, replayChecksum(std::span(head).first(kOffsetChecksum)));
  bytes.insert(bytes.end(), head.begin(), head.end());
}

namespace {

void putStored(Bytes& bytes, uint32_t kind, uint32_t flags, uint32_t firstTick, size_t rawBytes,
               std::span<const uint8_t> stored) {
  putLittle(bytes, kind);
  putLittle(bytes, flags);
  putLittle(bytes, uint32_t(rawBytes));
  putLittle(bytes, uint32_t(stored.size()));
  putLittle(bytes, firstTick);
  putLittle(bytes, uint32_t(0));
  putLittle(bytes, replayChecksum(stored));
  bytes.insert(bytes.end(), stored.begin(), stored.end());
}

}  // namespace

void putPlainChunk(Bytes& bytes, uint32_t kind, uint32_t flags, uint32_t firstTick, std::span<const uint8_t> payload) {
  putStored(bytes, kind, flags, firstTick, payload.size(), payload);
}

void putChunk(Bytes& bytes, uint32_t kind, uint32_t flags, uint32_t firstTick, std::span<const uint8_t> payload) {
  const Bytes stream = deflated(payload);
  putStored(bytes, kind, flags, firstTick, payload.size(), stream.empty() ? payload : std::span(stream));
}

void putTables(Bytes& bytes, const RuleTexts& rules) {
  for (const RuleText* text : {&rules.game, &rules.enemies, &rules.waves}) {
    putLittle(bytes, uint32_t(text->text.size()));
    bytes.insert(bytes.end(), text->text.begin(), text->text.end());
  }
}

void putInputs(Bytes& bytes, std::span<const InputRecord> inputs) {
  for (size_t i = 0; i < inputs.size();) {
    size_t end = i + 1;
    while (end < inputs.size() && inputs[end] == inputs[i]) ++end;
    putLittle(bytes, uint32_t(end - i));
    putLittle(bytes, uint16_t(inputs[i].move_x));
    putLittle(bytes, uint16_t(inputs[i].move_y));
    putLittle(bytes, inputs[i].aim);
    putLittle(bytes, inputs[i].buttons);
    i = end;
  }
}

void putHashes(Bytes& bytes, std::span<const uint64_t> hashes) {
  for (const uint64_t hash : hashes) putLittle(bytes, hash);
}

void putFieldHashes(Bytes& bytes, std::span<const FieldHashes> fieldHashes) {
  putLittle(bytes, kHashFields);
  for (const FieldHashes& fields : fieldHashes) {
    for (const uint64_t hash : fields) putLittle(bytes, hash);
  }
}

void putFinal(Bytes& bytes, const FinalReport& result) {
  putLittle(bytes, result.score);
  putLittle(bytes, result.kills);
  putLittle(bytes, result.frameTime_us);
  putLittle(bytes, uint32_t(result.over));
}

}  // namespace gw
