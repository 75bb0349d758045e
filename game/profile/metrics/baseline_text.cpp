#include <fmt/format.h>

#include <cmath>

#include "game/profile/metrics/baseline.h"

namespace gw::profile {

namespace {

// About four digits, never an exponent.
std::string number(double value) {
  if (!std::isfinite(value)) return "-";
  const double size = std::abs(value);
  return fmt::format("{:.{}f}", value, size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : size >= 1 ? 3 : 4);
}

std::string ratioText(const Estimate& ratio) {
  if (!std::isfinite(ratio.value)) return "-";
  const std::string value = fmt::format("{:.3f}", ratio.value);
  return std::isnan(ratio.low) ? value : fmt::format("{} ({:.3f} to {:.3f})", value, ratio.low, ratio.high);
}

// One line instead of many: a whole contender that only one session has.
std::string onlyIn(const std::vector<Compared>& all, size_t first, size_t last) {
  bool noOld = true, noNew = true;
  for (size_t i = first; i < last; ++i) {
    noOld = noOld && std::isnan(all[i].old);
    noNew = noNew && std::isnan(all[i].now);
  }
  return noOld ? "only in the new session" : noNew ? "only in the old session" : "";
}

std::string line(const Compared& one) {
  std::string verdict = nameOf(one.verdict);
  if (one.failsGate) verdict += ", fails the gate";
  return fmt::format("  {} {:<26} {:<8} {:>10} {:>10}  {:<24} {}\n", one.gated ? '*' : ' ', one.metric,
                     metric(one.metric).unit, number(one.old), number(one.now), ratioText(one.ratio), verdict);
}

}  // namespace

const char* nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::faster:
      return "faster";
    case Verdict::slower:
      return "slower";
    case Verdict::same:
      return "same";
    case Verdict::tooFewRuns:
      return "too few runs";
    case Verdict::missing:
      break;
  }
  return "missing";
}

std::string baselineText(const Comparison& comparison) {
  if (!comparison.error.empty()) return comparison.error + "\n";
  std::string text;
  for (const std::string& sentence : comparison.differences) text += sentence + "\n";
  const std::vector<Compared>& all = comparison.compared;
  for (size_t first = 0, last = 0; first < all.size(); first = last) {
    while (last < all.size() && all[last].enemies == all[first].enemies &&
           all[last].contender == all[first].contender) {
      ++last;
    }
    text += std::to_string(all[first].enemies) + " enemies, " + all[first].contender;
    const std::string only = onlyIn(all, first, last);
    if (!only.empty()) {
      text += ": " + only + "\n";
      continue;
    }
    text += fmt::format("\n    {:<26} {:<8} {:>10} {:>10}  {:<24} {}\n", "metric (* gated)", "unit", "old", "now",
                        "now/old (95 % interval)", "verdict");
    for (size_t i = first; i < last; ++i) text += line(all[i]);
  }
  return text + comparison.gateSentence + "\n";
}

}  // namespace gw::profile
