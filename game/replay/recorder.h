// Collects a run tick by tick and writes its replay at the end. What is collected goes once a second to a file that
// grows beside the target, and that a later 'gpuwars replay' plays: a program that dies loses a second of the run at
// most.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "game/replay/replay.h"
#include "host/platform/append_file.h"

namespace gw {

class Recorder {
 public:
  // Makes the growing file at once, NAME.part-PID-N, so that a run does not fail at its end. Throws FileError.
  Recorder(std::filesystem::path path, ReplayHeader header, RuleTexts rules);
  // Without finish() or abandon(), as when an error ends the run, the growing file stays with all ticks that there are;
  // without a tick it goes.
  ~Recorder();
  Recorder(Recorder&&) = default;
  Recorder& operator=(Recorder&&) = delete;

  // The next tick: its input, as used, and the hashes after it. False, and nothing recorded, after kMaxTicks: finish
  // then with the report of the last recorded tick. Never allocates. A full disk is no error here: the growing file
  // goes on when there is room again, and finish() says what could not be written.
  bool append(const TickReport& report);

  // Writes the file and removes the growing one. Throws FileError when that fails or no tick was recorded; what stood
  // at the path is then untouched, and the growing file stays if it holds a tick. Once finished or abandoned it throws
  // std::logic_error.
  void finish(const FinalReport& result);

  // Drops what was recorded; finish() is then refused.
  void abandon();

  uint32_t ticks() const { return replay_.ticks(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  // Both append to the growing file; false when there is nothing to append, or no room.
  bool flushStart();
  bool flushBlock();

  std::filesystem::path path_;
  Replay replay_;
  std::unique_ptr<AppendFile> growing_;           // none once finished or abandoned, and in what was moved from
  std::vector<uint8_t> start_, block_, payload_;  // bytes on their way; with all the room they need
  uint32_t flushed_ = 0;                          // ticks in the growing file
};

}  // namespace gw
