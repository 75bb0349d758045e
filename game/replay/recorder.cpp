#include "game/replay/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "game/replay/replay_parts.h"
#include "game/replay/replay_writer.h"
#include "host/platform/atomic_file.h"

namespace gw {
namespace {

using namespace replay_format;

// What a block takes at most, for three payloads and their headers.
constexpr size_t kBlockBytes = kTicksPerGrowingBlock * (kRunBytes + kHashBytes) + 4 +
                               kTicksPerGrowingBlock / kFieldHashesEvery_ticks * sizeof(FieldHashes) +
                               3 * kChunkHeaderBytes;

}  // namespace

Recorder::Recorder(std::filesystem::path path, ReplayHeader header, RuleTexts rules)
    : path_(std::move(path)),
      replay_{std::move(header), std::move(rules), {}, {}, {}, {}},
      growing_(std::make_unique<AppendFile>(path_)) {
  std::string& options = replay_.header.options;  // for people only: cut rather than refused
  if (options.size() > kMaxOptionsBytes) options.resize(kMaxOptionsBytes);
  replay_.inputs.reserve(kMaxTicks);  // 15 MB of addresses; pages come as ticks do
  replay_.hashes.reserve(kMaxTicks);
  replay_.fieldHashes.reserve(kMaxTicks / kFieldHashesEvery_ticks);
  block_.reserve(kBlockBytes);
  payload_.reserve(kBlockBytes);

  putReplayHeader(start_, replay_.header, 0, 0);
  if (!options.empty()) {
    putChunk(start_, kOptionsChunk, 0, 0, {reinterpret_cast<const uint8_t*>(options.data()), options.size()});
  }
  std::vector<uint8_t> tables;
  putTables(tables, replay_.rules);
  putChunk(start_, kTablesChunk, kRequired, 0, tables);
  flushStart();
}

Recorder::~Recorder() {
  if (!growing_) return;
  while (flushBlock()) {
  }
  if (flushed_ == 0) growing_->remove();
}

bool Recorder::append(const TickReport& report) {
  if (!growing_ || ticks() == kMaxTicks) return false;
  replay_.inputs.push_back(report.input);
  replay_.hashes.push_back(report.hash);
  if (ticks() % kFieldHashesEvery_ticks == 0) {
    std::copy(std::begin(report.fieldHashes), std::end(report.fieldHashes), replay_.fieldHashes.emplace_back().begin());
  }
  // Two blocks a second catch up with a disk that was full for a while, and never hold a tick up for long.
  if (ticks() % kTicksPerGrowingBlock == 0) {
    if (flushBlock() && ticks() - flushed_ >= kTicksPerGrowingBlock) flushBlock();
  }
  return true;
}

bool Recorder::flushStart() {
  if (!start_.empty() && growing_->append(start_)) start_.clear();
  return start_.empty();
}

bool Recorder::flushBlock() {
  const uint32_t count = std::min(kTicksPerGrowingBlock, ticks() - flushed_);
  if (count == 0 || !flushStart()) return false;
  block_.clear();
  const auto chunk = [&](uint32_t kind, uint32_t flags, uint32_t firstTick, auto put, const auto& items) {
    payload_.clear();
    put(payload_, items);
    putPlainChunk(block_, kind, flags, firstTick, payload_);
  };
  chunk(kInputsChunk, kRequired, flushed_ + 1, putInputs, std::span(replay_.inputs).subspan(flushed_, count));
  chunk(kHashesChunk, kRequired, flushed_ + 1, putHashes, std::span(replay_.hashes).subspan(flushed_, count));
  const uint32_t firstFields = flushed_ / kFieldHashesEvery_ticks;
  const uint32_t fields = (flushed_ + count) / kFieldHashesEvery_ticks - firstFields;
  if (fields > 0) {
    chunk(kFieldHashesChunk, 0, (firstFields + 1) * kFieldHashesEvery_ticks, putFieldHashes,
          std::span(replay_.fieldHashes).subspan(firstFields, fields));
  }
  if (!growing_->append(block_)) return false;
  flushed_ += count;
  return true;
}

void Recorder::finish(const FinalReport& result) {
  if (!growing_) throw std::logic_error("the recording was finished or abandoned before");
  if (ticks() == 0) {
    abandon();
    throw ReplayError(
        fmt::format("{} was not written: not a single tick was played; play on before leaving", path_.string()));
  }
  replay_.result = result;
  try {
    writeReplay(path_, replay_);
  } catch (const FileError& error) {
    while (flushBlock()) {
    }
    const std::unique_ptr<AppendFile> growing = std::move(growing_);
    if (flushed_ == 0) {
      growing->remove();
      throw;
    }
    throw FileError(fmt::format("{}; its first {} ticks are in {}, which 'gpuwars trim' makes whole", error.what(),
                                flushed_, growing->path().string()));
  }
  abandon();
}

void Recorder::abandon() {
  if (growing_) growing_->remove();
  growing_.reset();
}

}  // namespace gw
