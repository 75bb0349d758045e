// Collects a run tick by tick and writes its replay at the end.
#pragma once

#include <cstdint>
#include <filesystem>

#include "game/replay/replay.h"

namespace gw {

class Recorder {
 public:
  // Checks at once that a file can be written at `path`, so that a run does not fail at its end. Throws
  // FileError. Nothing is left there until finish().
  Recorder(std::filesystem::path path, ReplayHeader header, RuleTexts rules);

  // The next tick's input, as used, and the hash after it. False, and nothing recorded, after kMaxTicks:
  // finish then with the report of the last recorded tick. Never allocates.
  bool append(const InputRecord& input, uint64_t hash);

  // Writes the file. Throws FileError when that fails or no tick was recorded; what stood at the path
  // is then untouched. Once finished or abandoned it throws std::logic_error.
  void finish(const FinalReport& result);

  // Drops what was recorded; finish() is then refused. Destruction without finish() does the same.
  void abandon();

  uint32_t ticks() const { return replay_.ticks(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Replay replay_;
  bool open_ = true;
};

}  // namespace gw
