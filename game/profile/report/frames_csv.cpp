#include "game/profile/report/frames_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "host/platform/part_file.h"

namespace gw::profile {

namespace {

constexpr size_t kBlockBytes = 1 << 20;
constexpr size_t kRowBytes = 4096;  // more than any row but one with hundreds of stages, which only allocates
constexpr size_t kNowhere = SIZE_MAX;
constexpr double kUnits = 1e4;  // four decimals
constexpr double kMaxFixed = 1e14;

std::string cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

FramesCsv::FramesCsv(const std::filesystem::path& path, std::vector<std::string> stages)
    : path_(path), stages_(std::move(stages)), file_(path) {
  rows_.reserve(kBlockBytes + kRowBytes);
  rows_ =
      "enemies,contender,run,frame,tick,warm_up,ticks,simulation_ms,draw_ms,wait_ms,total_ms,gl_ms,latency_ms,live,"
      "kills,candidates,neighbours,searching,gather_ms";
  for (const std::string& stage : stages_) rows_ += "," + cell(stage + "_ms");
  rows_ += '\n';
}

FramesCsv::~FramesCsv() {
  if (!finished_) file_.remove();
}

void FramesCsv::begin(uint32_t enemies, std::string_view contender, uint32_t run, std::span<const std::string> stages) {
  start_ = fmt::format("{},{},{},", enemies, cell(contender), run);
  frame_ = 0;
  staged_.assign(stages_.size(), kNowhere);
  for (size_t i = 0; i < stages.size(); ++i) {
    const auto column = std::find(stages_.begin(), stages_.end(), stages[i]);
    if (column == stages_.end()) throw std::invalid_argument("frames.csv has no column for stage " + stages[i]);
    staged_[size_t(column - stages_.begin())] = i;
  }
}

void FramesCsv::whole(uint64_t value) {
  const fmt::format_int text(value);
  rows_.append(text.data(), text.size());
  rows_ += ',';
}

// Ten times as fast as formatting a double.
void FramesCsv::number(double value) {
  if (!std::isfinite(value)) {
    rows_ += ',';
    return;
  }
  if (std::abs(value) >= kMaxFixed) {
    fmt::format_to(std::back_inserter(rows_), "{:.4f},", value);
    return;
  }
  int64_t units = std::llround(value * kUnits);
  if (units < 0) {
    rows_ += '-';
    units = -units;
  }
  const fmt::format_int text(units / int64_t(kUnits));
  rows_.append(text.data(), text.size());
  char fraction[] = ".0000,";
  auto rest = uint32_t(units % int64_t(kUnits));
  for (size_t at = 4; at > 0; --at, rest /= 10) fraction[at] = char('0' + rest % 10);
  rows_.append(fraction, 6);
}

void FramesCsv::count(double value) {
  if (value >= 0 && value < kMaxFixed && value == std::floor(value)) return whole(uint64_t(value));
  number(value);
}

void FramesCsv::add(const Frame& frame) {
  rows_ += start_;
  whole(frame_++);
  whole(frame.tick);
  whole(frame.warmUp);
  whole(frame.ticks);
  for (const double ms :
       {frame.simulation_ms, frame.draw_ms, frame.wait_ms, frame.total_ms, frame.gl_ms, frame.latency_ms}) {
    number(ms);
  }
  whole(frame.live);
  whole(frame.kills);
  count(frame.candidates);
  count(frame.neighbours);
  count(frame.searching);
  number(frame.gather_ms);
  for (const size_t at : staged_) {
    number(frame.staged && at < frame.stages_ms.size() ? double(frame.stages_ms[at]) : kUnknown);
  }
  rows_.back() = '\n';
  if (rows_.size() >= kBlockBytes) flush();
}

void FramesCsv::flush() {
  if (!file_.append({reinterpret_cast<const uint8_t*>(rows_.data()), rows_.size()})) {
    refuseWriting(path_, "the disk takes no more; make room or choose a folder on another disk");
  }
  rows_.clear();
}

void FramesCsv::finish() {
  flush();
  file_.become();
  finished_ = true;
}

}  // namespace gw::profile
