#include "game/profile/session/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace gw::profile {
namespace {

enum Track : uint32_t { kTicks = 1, kStages, kPictures };

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void Trace::add(const std::string& name, const RunFrames& run) {
  const uint32_t process = ++processes_;
  events_ += fmt::format("{{\"ph\":\"M\",\"pid\":{},\"name\":\"process_name\",\"args\":{{\"name\":{}}}}},\n", process,
                         quoted(name));
  nameTrack(process, kTicks, "ticks");
  nameTrack(process, kStages, "stages");
  if (run.drawn) nameTrack(process, kPictures, "pictures");
  for (size_t i = 0; i < std::min(run.frames.size(), kFrames); ++i) {
    const Frame& frame = run.frames[i];
    if (frame.ticks > 0 && frame.simulation_ms == frame.simulation_ms) {
      event(process, kTicks, fmt::format("tick {}", frame.tick), frame.begin_ms, frame.simulation_ms,
            fmt::format("\"ticks\":{},\"live\":{},\"kills\":{}", frame.ticks, frame.live, frame.kills));
    }
    double at_ms = frame.begin_ms;
    for (size_t s = 0; s < frame.stages_ms.size() && s < run.stages.size(); ++s) {
      const double took_ms = double(frame.stages_ms[s]) * frame.ticks;
      event(process, kStages, run.stages[s], at_ms, took_ms);
      at_ms += took_ms;
    }
    if (!run.drawn) continue;
    event(process, kPictures, "draw", frame.begin_ms + frame.simulation_ms, frame.draw_ms);
    event(process, kPictures, "wait", frame.begin_ms + frame.simulation_ms + frame.draw_ms, frame.wait_ms);
  }
}

// Viewers sort tracks by their names otherwise, and stages belong under their ticks.
void Trace::nameTrack(uint32_t process, uint32_t track, const std::string& name) {
  events_ += fmt::format("{{\"ph\":\"M\",\"pid\":{},\"tid\":{},\"name\":\"thread_name\",\"args\":{{\"name\":{}}}}},\n",
                         process, track, quoted(name));
  events_ += fmt::format(
      "{{\"ph\":\"M\",\"pid\":{0},\"tid\":{1},\"name\":\"thread_sort_index\",\"args\":{{\"sort_index\":{1}}}}},\n",
      process, track);
}

void Trace::event(uint32_t process, uint32_t track, const std::string& name, double begin_ms, double took_ms,
                  const std::string& arguments) {
  events_ += fmt::format("{{\"ph\":\"X\",\"pid\":{},\"tid\":{},\"name\":{},\"ts\":{:.1f},\"dur\":{:.1f}{}}},\n",
                         process, track, quoted(name), begin_ms * 1000, took_ms * 1000,
                         arguments.empty() ? "" : fmt::format(",\"args\":{{{}}}", arguments));
}

std::string Trace::json() const {
  const std::string events = events_.substr(0, events_.size() < 2 ? 0 : events_.size() - 2);  // no comma at the end
  return fmt::format("{{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n{}\n]}}\n", events);
}

}  // namespace gw::profile
