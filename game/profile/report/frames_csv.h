// frames.csv: every frame of a session, a row each, written while the session runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/profile/metrics/frame.h"
#include "host/platform/append_file.h"

namespace gw::profile {

// Grows beside its target and takes its name when finished: a frames.csv is always whole. A program that is
// killed leaves FRAMES.part-PID-N with the rows up to the last mebibyte; one that is not finished leaves nothing.
class FramesCsv {
 public:
  // `stages`: every one that some run of the session has, for a column each. Throws FileError, as all of it does.
  FramesCsv(const std::filesystem::path& path, std::vector<std::string> stages);
  ~FramesCsv();
  FramesCsv(const FramesCsv&) = delete;
  FramesCsv& operator=(const FramesCsv&) = delete;

  // Frames that follow are of this run, counted from 0. A stage that has no column throws std::invalid_argument.
  void begin(uint32_t enemies, std::string_view contender, uint32_t run, std::span<const std::string> stages);
  void add(const Frame& frame);
  void finish();

 private:
  void number(double value);  // and a comma, as all of these
  void whole(uint64_t value);
  void count(double value);
  void flush();

  std::filesystem::path path_;
  std::vector<std::string> stages_;
  AppendFile file_;
  std::string rows_;            // not yet handed to the system
  std::string start_;           // enemies, contender, run
  std::vector<size_t> staged_;  // column of the run's stages -> place in Frame::stages_ms
  uint64_t frame_ = 0;          // of the run
  bool finished_ = false;
};

}  // namespace gw::profile
