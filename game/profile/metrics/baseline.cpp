#include "game/profile/metrics/baseline.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

namespace gw::profile {

namespace {

template <class Named>
const Named* find(const std::vector<Named>& all, const auto& is) {
  const auto found = std::find_if(all.begin(), all.end(), is);
  return found == all.end() ? nullptr : &*found;
}

// What one session has of one metric: a value of each run that has it.
std::vector<double> valuesOf(const Contender* contender, const char* metric) {
  std::vector<double> values;
  if (!contender) return values;
  for (const MetricValues& run : contender->runs) {
    const auto found = run.find(metric);
    if (found != run.end() && std::isfinite(found->second)) values.push_back(found->second);
  }
  return values;
}

bool has(const Contender* contender, const char* metric) {
  return !valuesOf(contender, metric).empty();
}

// The rate is that of pictures where there are any.
bool isGated(const Contender* now, const Contender* old, std::string_view metric) {
  const bool drawn = has(now, "draw_ms.mean") || has(old, "draw_ms.mean");
  return metric == (drawn ? "meanFps" : "ticksPerSecond") || metric == "frame_ms.p99" ||
         metric == "upkeepAndGathering_ms.mean";
}

Verdict verdictOf(const Compared& compared, Better better, double spread) {
  if (std::isnan(compared.ratio.low)) return Verdict::tooFewRuns;
  const double change = std::abs(compared.now - compared.old);
  if (change <= spread || change <= kLeastChange * std::abs(compared.old)) return Verdict::same;
  if (compared.ratio.low > 1) return better == Better::lower ? Verdict::slower : Verdict::faster;
  if (compared.ratio.high < 1) return better == Better::lower ? Verdict::faster : Verdict::slower;
  return Verdict::same;
}

Compared compare(uint32_t enemies, const Contender* now, const Contender* old, const Metric& metric) {
  Compared compared;
  compared.enemies = enemies;
  compared.contender = now ? now->name : old->name;
  compared.metric = metric.name;
  compared.gated = isGated(now, old, metric.name);
  const std::vector<double> nows = valuesOf(now, metric.name), olds = valuesOf(old, metric.name);
  if (!nows.empty()) compared.now = mean(nows);
  if (!olds.empty()) compared.old = mean(olds);
  compared.ratio = bootstrapRatioApart(nows, olds);
  if (nows.empty() || olds.empty()) return compared;
  compared.verdict = verdictOf(compared, metric.better, std::max(deviation(nows), deviation(olds)));
  if (!compared.gated || compared.verdict == Verdict::tooFewRuns) return compared;
  compared.p = metric.better == Better::lower ? permutationP(nows, olds) : permutationP(olds, nows);
  return compared;
}

void compareContenders(Comparison& comparison, uint32_t enemies, const Contender* now, const Contender* old) {
  if (now && old && now->about != old->about) {
    comparison.differences.push_back(now->name + " with " + std::to_string(enemies) + " enemies was \"" + old->about +
                                     "\" and is \"" + now->about + "\".");
  }
  for (const Metric& metric : metrics()) {
    if (metric.better == Better::neither || !(has(now, metric.name) || has(old, metric.name))) continue;
    comparison.compared.push_back(compare(enemies, now, old, metric));
  }
  if (now && old && !now->hash.empty() && !old->hash.empty() && now->hash != old->hash) {
    comparison.differences.push_back(now->name + " with " + std::to_string(enemies) +
                                     " enemies ends in another state: what is simulated has changed, and a part of "
                                     "what differs may come from that.");
  }
}

void compareCases(Comparison& comparison, const Case* now, const Case* old) {
  static const std::vector<Contender> kNone;
  const auto& nows = now ? now->contenders : kNone;
  const auto& olds = old ? old->contenders : kNone;
  const uint32_t enemies = now ? now->enemies : old->enemies;
  const auto named = [](const std::string& name) { return [&](const Contender& c) { return c.name == name; }; };
  for (const Contender& one : nows) compareContenders(comparison, enemies, &one, find(olds, named(one.name)));
  for (const Contender& one : olds) {
    if (!find(nows, named(one.name))) compareContenders(comparison, enemies, nullptr, &one);
  }
}

std::string quoted(const std::string& text) {
  return text.empty() ? "unknown" : "\"" + text + "\"";
}

// Whether it is the same.
bool say(std::vector<std::string>& sentences, const char* what, const std::string& before, const std::string& after) {
  if (before == after) return true;
  sentences.push_back(std::string("Another ") + what + ": it was " + quoted(before) + " and is " + quoted(after) + ".");
  return false;
}

std::string quotaText(double quota) {
  char text[32] = "none";
  if (std::isfinite(quota)) std::snprintf(text, sizeof text, "%.2f", quota);
  return text;
}

// Whether both could count on their processors for the same. Reports of earlier programs do not say.
bool sayProcessors(std::vector<std::string>& sentences, const std::optional<ProcessorState>& now,
                   const std::optional<ProcessorState>& old) {
  bool same = true;
  if (now && old) {
    same &= say(sentences, "set of allowed processors", old->allowed, now->allowed);
    same &= say(sentences, "quota of the processors' time", quotaText(old->quota), quotaText(now->quota));
    same &= say(sentences, "governor", old->governor, now->governor);
    same &= say(sentences, "setting of turbo", old->turbo, now->turbo);
    same &= say(sentences, "range of clocks", old->clockRange, now->clockRange);
  }
  for (const auto& [which, processors] : {std::pair("old", &old), {"new", &now}}) {
    if (!*processors || !((*processors)->throttled_s > 0)) continue;
    char text[120];
    std::snprintf(text, sizeof text, "The quota of the processors' time held the %s session up for %.2f s.", which,
                  (*processors)->throttled_s);
    sentences.emplace_back(text);
    same = false;
  }
  return same;
}

// Whether it is the same machine.
bool sayDifferences(std::vector<std::string>& sentences, const Report& now, const Report& old) {
  bool same = true;
  const auto say = [&](const char* what, const std::string& before, const std::string& after) {
    return profile::say(sentences, what, before, after);
  };
  same &= say("processor", old.machine.cpu, now.machine.cpu);
  same &= say("number of cores", old.machine.cores, now.machine.cores);
  same &= say("GPU", old.machine.gpu, now.machine.gpu);
  same &= say("driver", old.machine.driver, now.machine.driver);
  same &= say("renderer", old.machine.renderer, now.machine.renderer);
  same &= say("system", old.machine.system, now.machine.system);
  same &= say("device", old.setup.device, now.setup.device);
  say("compiler", old.machine.compiler, now.machine.compiler);
  say("set of flags", old.machine.flags, now.machine.flags);
  say("commit", old.machine.commit, now.machine.commit);
  if (old.setup.interrupted) sentences.push_back("The old session was interrupted: some of its runs are missing.");
  if (now.setup.interrupted) sentences.push_back("The new session was interrupted: some of its runs are missing.");
  return same;
}

// Holm (1979): the smallest p against the error over all, the next against it over all but one, up to the first that
// is too great. Over all gated figures that can be judged, also those that are not slower.
void markFailures(std::vector<Compared>& compared) {
  std::vector<Compared*> judged;
  for (Compared& one : compared) {
    if (one.gated && !std::isnan(one.p)) judged.push_back(&one);
  }
  std::stable_sort(judged.begin(), judged.end(), [](const Compared* a, const Compared* b) { return a->p < b->p; });
  for (size_t i = 0; i < judged.size(); ++i) {
    if (judged[i]->p > kGateError / double(judged.size() - i)) break;
    judged[i]->failsGate = judged[i]->verdict == Verdict::slower;
  }
}

void judge(Comparison& comparison, bool sameMachine, bool sameProcessors) {
  size_t judged = 0, failed = 0, lacking = 0;
  for (const Compared& one : comparison.compared) {
    if (!one.gated) continue;
    failed += one.failsGate;
    judged += !std::isnan(one.p);
    // What the old session lacks is new, and no reason to distrust the rest.
    lacking += std::isnan(one.p) && !std::isnan(one.old);
  }
  const std::string count = std::to_string(judged) + " gated figures";
  if (!sameMachine) {
    comparison.gateSentence = "Gate: cannot judge, because machine or device are others.";
  } else if (!sameProcessors) {
    comparison.gateSentence =
        "Gate: cannot judge, because a quota held threads up, or affinity, quota or clocks are others.";
  } else if (failed > 0) {
    comparison.gate = Gate::slower;
    comparison.gateSentence = "Gate: failed, " + std::to_string(failed) + " of " + count + " slower beyond noise.";
  } else if (lacking > 0 || judged == 0) {
    comparison.gateSentence = "Gate: cannot judge, because " +
                              (judged + lacking == 0 ? std::string("there is no figure to judge")
                                                     : std::to_string(lacking) + " gated figures lack " +
                                                           std::to_string(kRunsForInterval) + " runs or are missing") +
                              ".";
  } else {
    comparison.gate = Gate::passed;
    comparison.gateSentence = "Gate: passed, none of " + count + " is slower beyond noise.";
  }
}

}  // namespace

std::string whyNotComparable(const Setup& now, const Setup& old) {
  std::string parts;
  const auto require = [&](const char* what, const std::string& before, const std::string& after) {
    if (before != after) {
      parts += (parts.empty() ? "" : "; ") + std::string(what) + " was " + quoted(before) + " and is " + quoted(after);
    }
  };
  require("the scene", old.scene, now.scene);
  require("the mode", old.mode, now.mode);
  require("what is drawn", old.drawn, now.drawn);
  require("the pacing", old.pacing, now.pacing);
  require("the number of ticks", std::to_string(old.ticks), std::to_string(now.ticks));
  require("the warm-up in ticks", std::to_string(old.warmUp), std::to_string(now.warmUp));
  if (parts.empty()) return "";
  return "The sessions cannot be compared: " + parts + ". Measure again with the options of the old one.";
}

Comparison compareWithBaseline(const Report& now, const Report& old) {
  Comparison comparison;
  comparison.error = whyNotComparable(now.setup, old.setup);
  if (!comparison.error.empty()) return comparison;
  const bool sameMachine = sayDifferences(comparison.differences, now, old);
  const bool sameProcessors = sayProcessors(comparison.differences, now.machine.processors, old.machine.processors);
  const auto sized = [](uint32_t enemies) { return [enemies](const Case& c) { return c.enemies == enemies; }; };
  for (const Case& one : now.cases) compareCases(comparison, &one, find(old.cases, sized(one.enemies)));
  for (const Case& one : old.cases) {
    if (!find(now.cases, sized(one.enemies))) compareCases(comparison, nullptr, &one);
  }
  markFailures(comparison.compared);
  judge(comparison, sameMachine, sameProcessors);
  return comparison;
}

}  // namespace gw::profile
