#include "game/replay/recorder.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "game/files/atomic_file.h"
#include "game/replay/replay_writer.h"

namespace gw {

Recorder::Recorder(std::filesystem::path path, ReplayHeader header, RuleTexts rules)
    : path_(std::move(path)), replay_{std::move(header), std::move(rules), {}, {}, {}} {
  checkWritable(path_);
  std::string& options = replay_.header.options;  // for people only: cut rather than refused
  if (options.size() > replay_format::kMaxOptionsBytes) options.resize(replay_format::kMaxOptionsBytes);
  replay_.inputs.reserve(kMaxTicks);  // 14 MB of addresses; pages come as ticks do
  replay_.hashes.reserve(kMaxTicks);
}

bool Recorder::append(const InputRecord& input, uint64_t hash) {
  if (!open_ || replay_.ticks() == kMaxTicks) return false;
  replay_.inputs.push_back(input);
  replay_.hashes.push_back(hash);
  return true;
}

void Recorder::finish(const FinalReport& result) {
  if (!open_) throw std::logic_error("the recording was finished or abandoned before");
  open_ = false;
  if (replay_.ticks() == 0) {
    throw ReplayError(
        fmt::format("{} was not written: not a single tick was played; play on before leaving", path_.string()));
  }
  replay_.result = result;
  writeReplay(path_, replay_);
}

void Recorder::abandon() {
  open_ = false;
}

}  // namespace gw
