#include "game/replay/replay_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "game/files/atomic_file.h"
#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"

namespace gw {
namespace {

using namespace replay_format;
using Bytes = std::vector<uint8_t>;

void check(const Replay& replay) {
  const auto refuse = [](const char* what) { throw std::invalid_argument(fmt::format("unwritable replay: {}", what)); };
  const ReplayHeader& header = replay.header;
  if (replay.inputs.empty() || replay.inputs.size() > kMaxTicks) refuse("number of ticks");
  if (replay.inputs.size() != replay.hashes.size()) refuse("as many hashes as inputs are needed");
  if (header.enemies < 1 || header.enemies > kMaxEnemies) refuse("number of enemies");
  if (header.mode > Mode::practice || header.autopilot > Autopilot::expert) refuse("mode or autopilot");
  if (header.gather > Gather::fixed || header.sort > Sort::oddEven) refuse("gather or sort");
  if (header.gather == Gather::exact && header.sort != Sort::bitonic) refuse("no exact gather goes with that sort");
  if (header.options.size() > kMaxOptionsBytes) refuse("options text too long");
  for (const RuleText* text : {&replay.rules.game, &replay.rules.enemies, &replay.rules.waves}) {
    if (text->text.size() > kMaxRuleText) refuse("rule text too long");
  }
  for (const InputRecord& input : replay.inputs) {
    if (input.move_x < -kStickFull || input.move_y < -kStickFull || (input.buttons & ~kButtonsKnown)) {
      refuse("an input record out of its range");
    }
  }
}

class FileBuilder {
 public:
  explicit FileBuilder(const Replay& replay) : bytes_(kHeaderBytes, 0) {
    std::copy(kMagic.begin(), kMagic.end(), bytes_.begin());
    putLittleAt(bytes_, kOffsetMajor, kReplayMajor);
    putLittleAt(bytes_, kOffsetMinor, kReplayMinor);
    putLittleAt(bytes_, kOffsetHeaderBytes, uint32_t(kHeaderBytes));
    putLittleAt(bytes_, kOffsetSimulationVersion, replay.header.simulationVersion);
    putLittleAt(bytes_, kOffsetSeed, replay.header.seed);
    putLittleAt(bytes_, kOffsetMode, uint32_t(replay.header.mode));
    putLittleAt(bytes_, kOffsetEnemies, replay.header.enemies);
    putLittleAt(bytes_, kOffsetAutopilot, uint32_t(replay.header.autopilot));
    putLittleAt(bytes_, kOffsetTicks, replay.ticks());
    putLittleAt(bytes_, kOffsetGather, uint32_t(replay.header.gather));
    putLittleAt(bytes_, kOffsetSort, uint32_t(replay.header.sort));
  }

  void chunk(uint32_t kind, uint32_t flags, uint32_t firstTick, const Bytes& payload) {
    putLittle(bytes_, kind);
    putLittle(bytes_, flags);
    putLittle(bytes_, uint32_t(payload.size()));
    putLittle(bytes_, firstTick);
    putLittle(bytes_, replayChecksum(payload));
    bytes_.insert(bytes_.end(), payload.begin(), payload.end());
    ++chunks_;
  }

  // Completes the header, then closes the file with the checksum of all before.
  Bytes finish() {
    putLittleAt(bytes_, kOffsetChunks, chunks_ + 1);
    putLittleAt(bytes_, kOffsetChecksum, replayChecksum(std::span(bytes_).first(kOffsetChecksum)));
    Bytes payload;
    putLittle(payload, replayChecksum(bytes_));
    chunk(kEndChunk, kRequired, 0, payload);
    return std::move(bytes_);
  }

 private:
  Bytes bytes_;
  uint32_t chunks_ = 0;
};

Bytes tablesPayload(const RuleTexts& rules) {
  Bytes payload;
  for (const RuleText* text : {&rules.game, &rules.enemies, &rules.waves}) {
    putLittle(payload, uint32_t(text->text.size()));
    payload.insert(payload.end(), text->text.begin(), text->text.end());
  }
  return payload;
}

void addInputs(FileBuilder& file, const std::vector<InputRecord>& inputs) {
  Bytes payload;
  size_t chunkStart = 0;
  for (size_t i = 0; i < inputs.size();) {
    size_t end = i + 1;
    while (end < inputs.size() && inputs[end] == inputs[i]) ++end;
    if (payload.size() + kRunBytes > kMaxChunkBytes) {
      file.chunk(kInputsChunk, kRequired, uint32_t(chunkStart + 1), payload);
      payload.clear();
      chunkStart = i;
    }
    putLittle(payload, uint32_t(end - i));
    putLittle(payload, uint16_t(inputs[i].move_x));
    putLittle(payload, uint16_t(inputs[i].move_y));
    putLittle(payload, inputs[i].aim);
    putLittle(payload, inputs[i].buttons);
    i = end;
  }
  file.chunk(kInputsChunk, kRequired, uint32_t(chunkStart + 1), payload);
}

void addHashes(FileBuilder& file, const std::vector<uint64_t>& hashes) {
  constexpr size_t kPerChunk = kMaxChunkBytes / kHashBytes;
  for (size_t start = 0; start < hashes.size(); start += kPerChunk) {
    Bytes payload;
    for (size_t i = start; i < std::min(start + kPerChunk, hashes.size()); ++i) putLittle(payload, hashes[i]);
    file.chunk(kHashesChunk, kRequired, uint32_t(start + 1), payload);
  }
}

Bytes finalPayload(const FinalReport& result) {
  Bytes payload;
  putLittle(payload, result.score);
  putLittle(payload, result.kills);
  putLittle(payload, result.frameTime_us);
  putLittle(payload, uint32_t(result.over));
  return payload;
}

}  // namespace

std::vector<uint8_t> encodeReplay(const Replay& replay) {
  check(replay);
  FileBuilder file(replay);
  if (!replay.header.options.empty()) {
    file.chunk(kOptionsChunk, 0, 0, Bytes(replay.header.options.begin(), replay.header.options.end()));
  }
  file.chunk(kTablesChunk, kRequired, 0, tablesPayload(replay.rules));
  addInputs(file, replay.inputs);
  addHashes(file, replay.hashes);
  file.chunk(kFinalChunk, kRequired, 0, finalPayload(replay.result));
  return file.finish();
}

void writeReplay(const std::filesystem::path& path, const Replay& replay) {
  writeFileAtomically(path, encodeReplay(replay));
}

}  // namespace gw
