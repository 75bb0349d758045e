// What each chunk of a replay means, and whether they make a run.
#include <fmt/format.h>

#include <algorithm>

#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"
#include "game/replay/chunk_frames.h"
#include "game/replay/replay_header.h"
#include "game/replay/replay_reader.h"

namespace gw {
namespace {

using namespace replay_format;
using Bytes = std::span<const uint8_t>;

// Grows by doubling, yet never past what can be needed.
template <typename T>
void makeRoom(std::vector<T>& items, size_t more, size_t limit) {
  const size_t needed = items.size() + more;
  if (needed > items.capacity()) items.reserve(std::min(limit, std::max(needed, 2 * items.capacity())));
}

class Decoder {
 public:
  Decoder(Bytes file, const std::string& name, SimulationVersions versions, Completeness completeness)
      : file_(file),
        refusal_(name),
        header_(readReplayHeader(file, refusal_, versions)),
        frames_(file, header_.major, refusal_),
        completeness_(completeness),
        maxTicks_(header_.growing() ? kMaxTicks : header_.ticks) {
    replay_.header = header_.run;
  }

  Replay decode() {
    for (uint32_t i = 1; !haveEnd_; ++i) {
      const std::optional<Chunk> chunk = frames_.next();
      if (!chunk) return decodePartial();
      if ((chunk->kind == kEndChunk) != (i == header_.chunks)) damaged("the END! chunk is not where the header says");
      readChunk(*chunk);
    }
    if (frames_.left() > 0) damaged(fmt::format("{} bytes follow its end", frames_.left()));
    checkComplete();
    return std::move(replay_);
  }

 private:
  [[noreturn]] void damaged(const std::string& what) const { refusal_.damaged(what); }

  void readChunk(const Chunk& chunk) {
    switch (chunk.kind) {
      case kOptionsChunk:
        return readOptions(chunk);
      case kTablesChunk:
        return readTables(chunk);
      case kInputsChunk:
        return readInputs(chunk);
      case kHashesChunk:
        return readHashes(chunk);
      case kFieldHashesChunk:
        return readFieldHashes(chunk);
      case kFinalChunk:
        return readFinal(chunk);
      case kEndChunk:
        return readEnd(chunk);
      default:
        if (chunk.flags & kRequired) {
          refusal_.refuse(
              fmt::format("the replay needs chunk {}, which this program does not know; use a newer GpuWars",
                          chunkName(chunk.kind)));
        }
    }
  }

  // Chunks of which a file holds one.
  Bytes once(const Chunk& chunk, bool& seen, uint32_t flags) {
    if (seen) damaged(fmt::format("chunk {} stands in it twice", chunkName(chunk.kind)));
    if (chunk.flags != flags || chunk.firstTick != 0)
      damaged(fmt::format("chunk {} is mislabelled", chunkName(chunk.kind)));
    seen = true;
    return frames_.payload(chunk);
  }

  // Chunks that together hold every tick in order.
  Bytes continues(const Chunk& chunk, uint32_t flags, size_t nextTick) {
    const std::string name = chunkName(chunk.kind);
    if (chunk.flags != flags) damaged(fmt::format("chunk {} is mislabelled", name));
    if (chunk.firstTick != nextTick) damaged(fmt::format("chunk {} does not continue the one before", name));
    return frames_.payload(chunk);
  }
  void wholeItems(const Chunk& chunk, Bytes payload, size_t itemBytes) const {
    if (payload.empty() || payload.size() % itemBytes)
      damaged(fmt::format("chunk {} has a broken length", chunkName(chunk.kind)));
  }

  void readOptions(const Chunk& chunk) {
    if (chunk.rawBytes > kMaxOptionsBytes) damaged("its options text is too long");
    const Bytes payload = once(chunk, haveOptions_, 0);
    replay_.header.options.assign(payload.begin(), payload.end());
  }

  void readTables(const Chunk& chunk) {
    const Bytes payload = once(chunk, haveTables_, kRequired);
    size_t offset = 0;
    const auto next = [&](RuleText& text, const char* file) {
      const size_t left = payload.size() - offset;
      if (left < 4) damaged("its rule tables end early");
      const uint32_t length = getLittle<uint32_t>(payload, offset);
      if (length > left - 4 || length > kMaxRuleText) damaged("a rule table is longer than its chunk");
      const Bytes bytes = payload.subspan(offset + 4, length);
      text = {fmt::format("{} in {}", file, refusal_.name()), std::string(bytes.begin(), bytes.end())};
      offset += 4 + length;
    };
    next(replay_.rules.game, "game.toml");
    next(replay_.rules.enemies, "enemies.toml");
    next(replay_.rules.waves, "waves.toml");
    if (offset != payload.size()) damaged("its rule tables are followed by something else");
  }

  void readInputs(const Chunk& chunk) {
    const Bytes payload = continues(chunk, kRequired, replay_.inputs.size() + 1);
    wholeItems(chunk, payload, kRunBytes);
    for (size_t at = 0; at < payload.size(); at += kRunBytes) {
      const uint32_t length = getLittle<uint32_t>(payload, at);
      if (length < 1 || length > maxTicks_ - replay_.inputs.size()) damaged("it has more inputs than ticks");
      InputRecord input;
      input.move_x = int16_t(getLittle<uint16_t>(payload, at + 4));
      input.move_y = int16_t(getLittle<uint16_t>(payload, at + 6));
      input.aim = getLittle<uint16_t>(payload, at + 8);
      input.buttons = getLittle<uint16_t>(payload, at + 10);
      if (input.move_x < -kStickFull || input.move_y < -kStickFull || (input.buttons & ~kButtonsKnown)) {
        damaged("an input is out of range");
      }
      makeRoom(replay_.inputs, length, maxTicks_);
      replay_.inputs.insert(replay_.inputs.end(), length, input);
    }
  }

  void readHashes(const Chunk& chunk) {
    const Bytes payload = continues(chunk, kRequired, replay_.hashes.size() + 1);
    wholeItems(chunk, payload, kHashBytes);
    const size_t count = payload.size() / kHashBytes;
    if (count > maxTicks_ - replay_.hashes.size()) damaged("it has more hashes than ticks");
    makeRoom(replay_.hashes, count, maxTicks_);
    for (size_t i = 0; i < count; ++i) replay_.hashes.push_back(getLittle<uint64_t>(payload, i * kHashBytes));
  }

  // A later version may have more fields, behind those that are known here.
  void readFieldHashes(const Chunk& chunk) {
    std::vector<FieldHashes>& all = replay_.fieldHashes;
    const Bytes payload = continues(chunk, 0, (all.size() + 1) * kFieldHashesEvery_ticks);
    const uint32_t fields = payload.size() < 4 ? 0 : getLittle<uint32_t>(payload, 0);
    if (fields < kHashFields || fields > kMaxStoredFields) damaged("its number of fields is out of range");
    const Bytes records = payload.subspan(4);
    wholeItems(chunk, records, fields * kHashBytes);
    const size_t count = records.size() / (fields * kHashBytes), limit = maxTicks_ / kFieldHashesEvery_ticks;
    if (count > limit - all.size()) damaged("it has more hashes by field than ticks");
    makeRoom(all, count, limit);
    for (size_t i = 0; i < count; ++i) {
      FieldHashes& item = all.emplace_back();
      for (uint32_t field = 0; field < kHashFields; ++field) {
        item[field] = getLittle<uint64_t>(records, (i * fields + field) * kHashBytes);
      }
    }
  }

  void readFinal(const Chunk& chunk) {
    const Bytes payload = once(chunk, haveFinal_, kRequired);
    if (payload.size() != kFinalBytes) damaged("its final report has another length");
    const uint32_t over = getLittle<uint32_t>(payload, 20);
    if (over > 1) damaged("its final report is out of range");
    replay_.result = {getLittle<uint64_t>(payload, 0), getLittle<uint64_t>(payload, 8),
                      getLittle<uint32_t>(payload, 16), over == 1};
  }

  void readEnd(const Chunk& chunk) {
    const Bytes payload = once(chunk, haveEnd_, kRequired);
    if (payload.size() != kEndBytes) damaged("its END! chunk has another length");
    if (getLittle<uint64_t>(payload, 0) != replayChecksum(file_.first(chunk.offset))) {
      damaged("the checksum of the whole file differs");
    }
  }

  void checkComplete() const {
    if (!haveTables_) damaged("its rule tables are missing");
    if (!haveFinal_) damaged("its final report is missing");
    if (replay_.inputs.size() != header_.ticks) damaged("inputs are missing");
    if (replay_.hashes.size() != header_.ticks) damaged("hashes are missing");
    const size_t fields = replay_.fieldHashes.size();
    if (fields != 0 && fields != header_.ticks / kFieldHashesEvery_ticks) damaged("hashes by field are missing");
  }

  // The ticks of which both input and hash are there.
  Replay decodePartial() {
    const size_t ticks = std::min(replay_.inputs.size(), replay_.hashes.size());
    if (!haveTables_ || ticks == 0) {
      if (!header_.growing()) damaged(frames_.ending());
      refusal_.refuse(
          "the recording was cut short within its first second, and nothing can be played; delete the file");
    }
    if (completeness_ == Completeness::whole) {
      refusal_.refuse(fmt::format(
          "the replay ends after tick {0} without its end mark; watch it with 'gpuwars replay {1}', or make "
          "it whole with 'gpuwars trim {1} --out NEW.gwr'",
          ticks, refusal_.name()));
    }
    replay_.inputs.resize(ticks);
    replay_.hashes.resize(ticks);
    replay_.fieldHashes.resize(std::min(replay_.fieldHashes.size(), ticks / kFieldHashesEvery_ticks));
    replay_.result = {};
    replay_.whole = false;
    return std::move(replay_);
  }

  Bytes file_;
  ReplayRefusal refusal_;
  ReplayFileHeader header_;
  ChunkFrames frames_;
  Completeness completeness_;
  uint32_t maxTicks_;
  Replay replay_;
  bool haveOptions_ = false, haveTables_ = false, haveFinal_ = false, haveEnd_ = false;
};

}  // namespace

Replay decodeReplay(std::span<const uint8_t> bytes, const std::string& name, SimulationVersions versions,
                    Completeness completeness) {
  return Decoder(bytes, name, versions, completeness).decode();
}

}  // namespace gw
