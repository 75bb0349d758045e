// A session against an earlier one: what became faster, what slower, and whether that is more than noise.
//
// "Slower" holds all of this, of the means over runs (`faster` the same on the other side):
//   1. both sessions have kRunsForInterval runs of the figure, else `tooFewRuns`;
//   2. the 95 % interval of now / old lies wholly on the worse side of 1;
//   3. the means differ by more than the greater of the two standard deviations from run to run;
//   4. and by more than kLeastChange of the old mean.
// Where nothing changed, one figure in about a hundred is slower by chance, so among many some always are. The *gate*
// therefore looks at three of each contender alone: meanFps (ticksPerSecond where nothing is drawn), frame_ms.p99 and
// upkeepAndGathering_ms.mean. What is slower of them fails it if a permutation test of old and new runs, with Holm's
// correction for the number of all gated figures, says that it is not chance: at most one gate in twenty fails so.
#pragma once

#include <string>
#include <vector>

#include "game/profile/metrics/report.h"

namespace gw::profile {

// Sessions differ by what no run of them shows: where memory lies, what else was started. Below this, nothing is
// reported.
inline constexpr double kLeastChange = 0.01;

// How often the gate may fail where nothing changed.
inline constexpr double kGateError = 0.05;

enum class Verdict { faster, slower, same, tooFewRuns, missing };
const char* nameOf(Verdict verdict);

// One metric of one contender in one case.
struct Compared {
  uint32_t enemies = 0;
  std::string contender;
  std::string metric;
  double old = kUnknown, now = kUnknown;  // means over runs
  Estimate ratio;                         // now / old
  Verdict verdict = Verdict::missing;     // of either session
  bool gated = false;
  double p = kUnknown;     // gated: that chance alone makes it as much worse
  bool failsGate = false;  // slower, and beyond chance among all gated ones
};

enum class Gate {
  passed,
  slower,       // one at least fails it
  cannotJudge,  // another machine, device or state of its processors, or a gated figure lacks runs or is missing now
};

struct Comparison {
  std::string error;                     // not "": they measured different things, and nothing else is filled in
  std::vector<std::string> differences;  // whole sentences: machine, build, interruptions, other hashes
  std::vector<Compared> compared;        // by case, contender and metric, in the order of the new session
  Gate gate = Gate::cannotJudge;
  std::string gateSentence;
};

// Why figures of these sessions mean different things, one sentence; empty: they mean the same. Known before the
// first run is made.
std::string whyNotComparable(const Setup& now, const Setup& old);

// An error: another scene, mode, picture, pacing, number of ticks or warm-up. Said, and the gate cannot judge: another
// machine, renderer or device; another affinity, quota, governor, turbo or range of clocks, or threads held up by a
// quota. Only said: another compiler, flags, commit; states that differ; a session cut short.
Comparison compareWithBaseline(const Report& now, const Report& old);

// For a terminal. Ends with the gate's sentence.
std::string baselineText(const Comparison& comparison);

}  // namespace gw::profile
