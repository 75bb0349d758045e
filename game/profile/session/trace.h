// The first run of every contender as trace events, which chrome://tracing and ui.perfetto.dev show: ticks, their
// stages, draws and waits.
#pragma once

#include <filesystem>
#include <string>

#include "game/profile/metrics/frame.h"

namespace gw::profile {

class Trace {
 public:
  // At most so many frames of a run: a minute of them; viewers become slow with more.
  static constexpr size_t kFrames = 3600;

  // `name` heads the run's tracks. Stages are laid one after the other from the start of the tick: only how long each
  // took is measured.
  void add(const std::string& name, const RunFrames& run);

  std::string json() const;

 private:
  void event(uint32_t process, uint32_t track, const std::string& name, double begin_ms, double took_ms,
             const std::string& arguments = {});
  void nameTrack(uint32_t process, uint32_t track, const std::string& name);

  std::string events_;
  uint32_t processes_ = 0;
};

}  // namespace gw::profile
