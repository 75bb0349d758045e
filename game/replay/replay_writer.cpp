#include "game/replay/replay_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"
#include "game/replay/replay_parts.h"
#include "host/platform/atomic_file.h"

namespace gw {
namespace {

using namespace replay_format;
using Bytes = std::vector<uint8_t>;

void check(const Replay& replay) {
  const auto refuse = [](const char* what) { throw std::invalid_argument(fmt::format("unwritable replay: {}", what)); };
  const ReplayHeader& header = replay.header;
  if (replay.inputs.empty() || replay.inputs.size() > kMaxTicks) refuse("number of ticks");
  if (replay.inputs.size() != replay.hashes.size()) refuse("as many hashes as inputs are needed");
  if (!replay.fieldHashes.empty() && replay.fieldHashes.size() != replay.inputs.size() / kFieldHashesEvery_ticks) {
    refuse("hashes by field of all ticks or of none are needed");
  }
  if (!replay.whole) refuse("its end is missing");
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

// What a replay is made of, ticks [start, end) of it.
struct Block {
  Bytes inputs, hashes, fields;  // payloads; no fields: the block holds none
  uint32_t firstTick = 0, firstFieldsTick = 0;
};

Block blockOf(const Replay& replay, size_t start, size_t end) {
  Block block;
  block.firstTick = uint32_t(start + 1);
  putInputs(block.inputs, std::span(replay.inputs).subspan(start, end - start));
  putHashes(block.hashes, std::span(replay.hashes).subspan(start, end - start));
  const size_t first = start / kFieldHashesEvery_ticks;
  const size_t last = std::min(end / kFieldHashesEvery_ticks, replay.fieldHashes.size());
  if (first < last) {
    block.firstFieldsTick = uint32_t((first + 1) * kFieldHashesEvery_ticks);
    putFieldHashes(block.fields, std::span(replay.fieldHashes).subspan(first, last - first));
  }
  return block;
}

}  // namespace

std::vector<uint8_t> encodeReplay(const Replay& replay) {
  check(replay);
  Bytes chunks;
  uint32_t count = 0;
  const auto add = [&](uint32_t kind, uint32_t flags, uint32_t firstTick, std::span<const uint8_t> payload) {
    putChunk(chunks, kind, flags, firstTick, payload);
    ++count;
  };
  const std::string& options = replay.header.options;
  if (!options.empty()) add(kOptionsChunk, 0, 0, {reinterpret_cast<const uint8_t*>(options.data()), options.size()});
  Bytes payload;
  putTables(payload, replay.rules);
  add(kTablesChunk, kRequired, 0, payload);
  for (size_t start = 0; start < replay.inputs.size(); start += kTicksPerBlock) {
    const Block block = blockOf(replay, start, std::min<size_t>(start + kTicksPerBlock, replay.inputs.size()));
    add(kInputsChunk, kRequired, block.firstTick, block.inputs);
    add(kHashesChunk, kRequired, block.firstTick, block.hashes);
    if (!block.fields.empty()) add(kFieldHashesChunk, 0, block.firstFieldsTick, block.fields);
  }
  payload.clear();
  putFinal(payload, replay.result);
  add(kFinalChunk, kRequired, 0, payload);

  Bytes file;
  putReplayHeader(file, replay.header, replay.ticks(), count + 1);
  file.insert(file.end(), chunks.begin(), chunks.end());
  payload.clear();
  putLittle(payload, replayChecksum(file));
  putPlainChunk(file, kEndChunk, kRequired, 0, payload);
  return file;
}

void writeReplay(const std::filesystem::path& path, const Replay& replay) {
  writeFileAtomically(path, encodeReplay(replay));
}

}  // namespace gw
