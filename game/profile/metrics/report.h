// Everything a profiling session found: what report.json holds, and all that the pictures and the page are made from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "game/profile/metrics/metrics.h"
#include "host/platform/statistics.h"

namespace gw::profile {

inline constexpr uint32_t kReportVersion = 1;

// What a session could count on its processors for. Texts are empty where the system does not say.
struct ProcessorState {
  std::string allowed;                      // "0-3,8"
  double quota = kUnknown;                  // the time of how many processors; unknown: no limit
  double throttled_s = kUnknown;            // for which that quota kept threads waiting meanwhile, summed over them
  std::string governor, turbo, clockRange;  // "performance", "off", "800 to 3400 MHz"
};

// Where it was measured. Texts are empty, and numbers NaN, where the machine does not say.
struct Machine {
  std::string cpu, cores, gpu, driver, renderer, compiler, flags, commit, system;
  double loadBefore = kUnknown, loadAfter = kUnknown;  // of one minute
  double gpuClock_MHz = kUnknown, gpuPower_W = kUnknown, gpuTemperature_C = kUnknown;
  std::optional<ProcessorState> processors{};  // none in reports of earlier programs
};

// What was asked for.
struct Setup {
  std::string scene;    // its name, or the replay's file
  std::string about;    // one sentence: what happens in it
  std::string mode;     // arcade ...
  std::string device;   // "cpu, 2 threads"
  std::string drawn;    // "window 1280x720", "offscreen 1280x720", "nothing: simulation only"
  std::string pacing;   // "a tick a frame" or "real time"
  uint32_t ticks = 0;   // of one run
  uint32_t warmUp = 0;  // ticks of it that are dropped
  uint32_t runs = 0;    // asked for; fewer were made when interrupted
  bool interrupted = false;
};

// One second of game time, over all runs.
struct Second {
  double time_s;                  // when it begins
  Estimate fps;                   // mean over runs; low and high: the slowest and the fastest
  double live;                    // enemies, mean
  std::vector<double> stages_ms;  // per tick, as Contender::stages; empty where none was timed
};

struct Bin {
  double from_ms, to_ms;
  uint64_t frames;
};
struct CurvePoint {
  double x, y;
};

// One way of finding neighbours in one case.
struct Contender {
  std::string name;                         // "ngrid"
  std::string about;                        // "NGrid, exact gather, frozen rows"
  bool shadow = false;                      // only upkeep and gathering, on the positions of an exact run beside it
  std::string hash;                         // of the last tick, 16 hexadecimal digits; "" in shadow
  std::vector<MetricValues> runs;           // in the order in which they were made
  std::map<std::string, Estimate> overall;  // mean over runs
  std::vector<std::string> stages;
  std::vector<double> stages_ms;         // mean per tick, as stages
  std::vector<Second> seconds;           // empty in shadow, as all below is
  std::vector<Bin> histogram;            // of frame times, all runs; equal widths of the logarithm
  std::vector<CurvePoint> percentiles;   // x percent, y ms
  std::vector<CurvePoint> tickOverLive;  // x live enemies, y ms per tick: medians of bins
};

// How a contender compares with the first of its case: greater than 1 where the first is faster.
struct SpeedUp {
  std::string contender;
  Estimate upkeepAndGathering, tick, frame;  // the value NaN: not measured
};

// All contenders at one number of enemies.
struct Case {
  uint32_t enemies = 0;
  std::vector<Contender> contenders;
  std::vector<SpeedUp> speedUps;  // of all but the first
};

// How the tick of a contender grows with live enemies, over all cases.
struct Growth {
  std::string contender;
  std::optional<PowerFit> fit;
  std::string why;  // no fit: the reason
};

struct Report {
  Machine machine;
  Setup setup;
  std::vector<Case> cases;
  std::vector<Growth> growth;
  double stageTimersCost = kUnknown;  // share that timing the stages adds to a tick
  std::vector<std::string> warnings;  // whole sentences: a noisy machine, too few runs
};

}  // namespace gw::profile
