#include "game/profile/report/summary.h"

#include <fmt/format.h>

#include <cmath>

#include "game/profile/report/number_text.h"

namespace gw::profile {

namespace {

// "412.3 ticks/s, 98.20 frames/s"; a frame that is not drawn is a tick.
std::string ratesText(const Contender& of, bool drawn) {
  std::string text;
  const auto add = [&](const char* metric, const char* unit) {
    const auto found = of.overall.find(metric);
    if (found == of.overall.end() || !std::isfinite(found->second.value)) return;
    text += (text.empty() ? "" : ", ") + figureText(found->second.value) + unit;
  };
  add("ticksPerSecond", " ticks/s");
  if (drawn) add("meanFps", " frames/s");
  return text.empty() ? "no rate was measured" : text;
}

std::string intervalText(const Estimate& ratio) {
  if (!std::isfinite(ratio.low) || !std::isfinite(ratio.high)) return " (too few runs for an interval)";
  return fmt::format(" (95 % interval {:.2f} to {:.2f})", ratio.low, ratio.high);
}

// "; its tick is 1.97 times as fast as that of grid-hashed (95 % interval 1.93 to 2.01), and 3.40 times as ..."
std::string speedUpsText(const Case& of) {
  std::string text;
  enum class Subject { none, tick, gathering } subject = Subject::none;
  for (const SpeedUp& speedUp : of.speedUps) {
    const bool ofTick = std::isfinite(speedUp.tick.value);
    const Estimate& ratio = ofTick ? speedUp.tick : speedUp.upkeepAndGathering;
    if (!std::isfinite(ratio.value)) continue;
    const Subject now = ofTick ? Subject::tick : Subject::gathering;
    const char* begins = now == subject ? "and" : ofTick ? "its tick is" : "its upkeep and gathering are";
    text += fmt::format("{} {} {:.2f} times as fast as {} of {}{}", text.empty() ? ";" : ",", begins, ratio.value,
                        ofTick ? "that" : "those", speedUp.contender, intervalText(ratio));
    subject = now;
  }
  return text;
}

}  // namespace

std::vector<std::string> summaryOf(const Report& report) {
  std::vector<std::string> sentences;
  for (const Case& of : report.cases) {
    if (of.contenders.empty()) continue;
    const Contender& first = of.contenders[0];
    const bool drawn = !report.setup.drawn.starts_with("nothing");
    sentences.push_back(first.name + ": " + ratesText(first, drawn) + " at " + enemiesText(of.enemies) +
                        speedUpsText(of) + ".");
  }
  if (sentences.empty()) sentences.push_back("Nothing was measured.");
  return sentences;
}

}  // namespace gw::profile
