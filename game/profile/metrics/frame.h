// What one frame of a profiled run cost, and one run of such frames.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace gw::profile {

// Stands for what was not measured in this frame.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Frame {
  uint32_t tick = 0;    // the last one it shows
  uint32_t ticks = 0;   // how many it simulated: one, or when paced none to five
  double begin_ms = 0;  // since the start of the run
  double simulation_ms = 0;
  double draw_ms = kUnknown;  // draw lists and the calls of OpenGL
  double wait_ms = kUnknown;  // until the picture was handed over; offscreen until it was whole
  double total_ms = 0;
  double gl_ms = kUnknown;       // of the draws, by the timer queries of OpenGL
  double latency_ms = kUnknown;  // from taking the input to the picture that shows it
  double candidates = kUnknown;  // tested by all enemies searching once; counted every 60th tick, outside of the frame
  double neighbours = kUnknown;  // of those, found
  double searching = kUnknown;   // enemies that searched
  double gather_ms = kUnknown;   // what that search took
  uint32_t live = 0;             // enemies
  uint32_t inView = 0;           // of them, in the view of a player
  uint64_t kills = 0;            // over the whole run
  bool warmUp = false;           // one of the first, which are dropped
  bool staged = false;           // its ticks were timed stage by stage
  bool disturbed = false;        // its times hold what timing the stages took: no total counts them
  std::vector<float> stages_ms;  // of one of its ticks, as RunFrames::stages; empty unless staged
};

// One of the repeated runs of one contender.
struct RunFrames {
  std::vector<std::string> stages;  // their names, in the order of the tick
  std::vector<Frame> frames;
  double timeToFirstFrame_ms = kUnknown;  // from the start of the run to its first picture or tick
  double droppedTicks = kUnknown;         // catch-up given up after the warm-up, when paced
  double launchesPerTick = 0;
  bool drawn = false;   // pictures were made; else a frame is a tick
  bool shadow = false;  // only upkeep and gathering were measured, on another run's positions
};

}  // namespace gw::profile
