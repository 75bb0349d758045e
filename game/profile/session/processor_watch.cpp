#include "game/profile/session/processor_watch.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace gw::profile {
namespace {

std::string thenText(const std::string& before, const std::string& after) {
  return before == after ? before
                         : (before.empty() ? "not said" : before) + ", then " + (after.empty() ? "not said" : after);
}

double throttledSoFar_s(const std::filesystem::path& root) {
  return ProcessorQuota(root).throttled_s().value_or(kUnknown);
}

// A quota that changed meanwhile is told by the lower of both.
double lower(const std::optional<double>& a, const std::optional<double>& b) {
  return std::fmin(a.value_or(kUnknown), b.value_or(kUnknown));
}

}  // namespace

ProcessorWatch::ProcessorWatch(std::filesystem::path root)
    : root_(std::move(root)),
      processors_(readProcessors(root_)),
      clocks_(readClocks(processors_.allowed, root_)),
      throttled_s_(throttledSoFar_s(root_)) {}

ProcessorState ProcessorWatch::state() const {
  const Processors processors = readProcessors(root_);
  const Clocks clocks = readClocks(processors.allowed, root_);
  ProcessorState state;
  state.allowed = thenText(processorList(processors_.allowed), processorList(processors.allowed));
  state.quota = lower(processors_.quota, processors.quota);
  state.throttled_s = throttledSoFar_s(root_) - (std::isfinite(throttled_s_) ? throttled_s_ : 0);
  state.governor = thenText(clocks_.governor, clocks.governor);
  state.turbo = thenText(clocks_.turbo, clocks.turbo);
  state.clockRange = thenText(clocks_.range, clocks.range);
  return state;
}

std::vector<std::string> ProcessorWatch::warnings(const ProcessorState& state) const {
  std::vector<std::string> sentences;
  if (state.throttled_s > 0) {
    sentences.push_back(
        fmt::format("A quota of {:.2g} of {} processors' time held threads up for {:.2f} s: ask for fewer "
                    "--threads, or measure without the quota.",
                    state.quota, processors_.present, state.throttled_s));
  }
  if (state.governor.find(", then ") != std::string::npos || !clocks_.fixed) {
    sentences.push_back(
        fmt::format("The governor of the clocks was {}{}, so figures depend on what ran before: set it to "
                    "performance (sudo cpupower frequency-set -g performance) and measure again.",
                    state.governor, state.clockRange.empty() ? "" : " (" + state.clockRange + ")"));
  }
  return sentences;
}

}  // namespace gw::profile
