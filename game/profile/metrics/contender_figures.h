// From the runs of one contender to all that its report says; from contenders to how they compare and grow.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "game/profile/metrics/report.h"

namespace gw::profile {

// Takes runs one after the other and keeps no frames: 12 bytes of each (of 18,000 frames and 10 runs, 2 MB).
class ContenderFigures {
 public:
  ContenderFigures(std::string name, std::string about);

  // Throws std::invalid_argument when its stages, or whether it is a shadow, are not as in the runs before.
  void add(const RunFrames& run);
  // All but the hash, which no frame knows. More runs may follow.
  Contender finish() const;

 private:
  // Sum and number, of means that are taken at the end.
  struct Sum {
    double total = 0;
    uint64_t count = 0;
    void add(double value, uint64_t times = 1);
    double mean() const;  // kUnknown of nothing
  };
  struct SecondSums {
    Sum fps;                     // of runs
    double low = 0, high = 0;    // of them
    Sum live;                    // of frames
    std::vector<Sum> stages_ms;  // of staged ticks
  };
  struct LiveBin {
    Sum live;                     // of ticks
    std::vector<float> ticks_ms;  // of them
  };

  void checkKind(const RunFrames& run);
  void addStages(const RunFrames& run);
  void addSeconds(const RunFrames& run);

  std::string name_, about_;
  bool shadow_ = false;
  std::vector<MetricValues> runs_;
  std::vector<std::string> stages_;
  std::vector<Sum> stages_ms_;  // of means of runs, so that they agree with the metrics
  std::map<uint32_t, SecondSums> seconds_;
  std::vector<float> frames_ms_;
  std::map<int, LiveBin> liveBins_;
};

// Bins of equal width of the logarithm, from the one with the shortest to the one with the longest; at most 80, and
// about the square root of the number of frames.
std::vector<Bin> histogramOf(std::span<const float> frames_ms);

// At 0, 1 ... 99, 99.5, 99.9, 99.99 and 100 %; but for the last, only as far as one frame at least lies beyond.
std::vector<CurvePoint> percentilesOf(std::vector<float> frames_ms);

// Runs are paired by their order: both contenders' first runs were made one right after the other. An
// interrupted session may lack the last run of a pair.
SpeedUp speedUpOf(const Contender& first, const Contender& other);

// One for each contender, in the order in which they appear first, through the bins of `tickOverLive` of all cases.
std::vector<Growth> growthOf(std::span<const Case> cases);

}  // namespace gw::profile
