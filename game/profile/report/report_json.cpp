#include "game/profile/report/report_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace gw::profile {

namespace {

using Json = nlohmann::ordered_json;

Json numberJson(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

template <class Numbers>
Json numbers(const Numbers& values) {
  Json json = Json::array();
  for (const auto value : values) json.push_back(numberJson(value));
  return json;
}

template <class Items, class Write>
Json list(const Items& items, const Write& write) {
  Json json = Json::array();
  for (const auto& item : items) json.push_back(write(item));
  return json;
}

Json estimate(const Estimate& of) {
  return {{"value", numberJson(of.value)}, {"low", numberJson(of.low)}, {"high", numberJson(of.high)}};
}

const char* nameOf(Better better) {
  switch (better) {
    case Better::higher:
      return "higher";
    case Better::lower:
      return "lower";
    case Better::neither:
      return "neither";
  }
  return "neither";
}

Json table() {
  return list(metrics(), [](const Metric& metric) {
    return Json{{"name", metric.name},
                {"unit", metric.unit},
                {"definition", metric.definition},
                {"better", nameOf(metric.better)}};
  });
}

Json processors(const ProcessorState& of) {
  return {{"allowed", of.allowed},
          {"quota", numberJson(of.quota)},
          {"throttled_s", numberJson(of.throttled_s)},
          {"governor", of.governor},
          {"turbo", of.turbo},
          {"clockRange", of.clockRange}};
}

Json machine(const Machine& of) {
  Json json{{"cpu", of.cpu},
            {"cores", of.cores},
            {"gpu", of.gpu},
            {"driver", of.driver},
            {"renderer", of.renderer},
            {"compiler", of.compiler},
            {"flags", of.flags},
            {"commit", of.commit},
            {"system", of.system},
            {"loadBefore", numberJson(of.loadBefore)},
            {"loadAfter", numberJson(of.loadAfter)},
            {"gpuClock_MHz", numberJson(of.gpuClock_MHz)},
            {"gpuPower_W", numberJson(of.gpuPower_W)},
            {"gpuTemperature_C", numberJson(of.gpuTemperature_C)}};
  if (of.processors) json["processors"] = processors(*of.processors);
  return json;
}

Json setup(const Setup& of) {
  return {{"scene", of.scene}, {"about", of.about},
          {"mode", of.mode},   {"device", of.device},
          {"drawn", of.drawn}, {"pacing", of.pacing},
          {"ticks", of.ticks}, {"warmUp_ticks", of.warmUp},
          {"runs", of.runs},   {"interrupted", of.interrupted}};
}

Json metricsOfRun(const MetricValues& run) {
  Json json = Json::object();
  for (const auto& [name, value] : run) json[name] = numberJson(value);
  return json;
}

Json secondJson(const Second& of) {
  return {{"time_s", numberJson(of.time_s)},
          {"fps", estimate(of.fps)},
          {"live", numberJson(of.live)},
          {"stages_ms", numbers(of.stages_ms)}};
}

Json contenderJson(const Contender& of) {
  Json overall = Json::object();
  for (const auto& [name, value] : of.overall) overall[name] = estimate(value);
  return {{"name", of.name},
          {"about", of.about},
          {"shadow", of.shadow},
          {"hash", of.hash},
          {"runs", list(of.runs, metricsOfRun)},
          {"overall", std::move(overall)},
          {"stages", of.stages},
          {"stages_ms", numbers(of.stages_ms)},
          {"seconds", list(of.seconds, secondJson)},
          {"histogram", list(of.histogram,
                             [](const Bin& bin) {
                               return Json{{"from_ms", numberJson(bin.from_ms)},
                                           {"to_ms", numberJson(bin.to_ms)},
                                           {"frames", bin.frames}};
                             })},
          {"percentiles", list(of.percentiles,
                               [](const CurvePoint& point) {
                                 return Json{{"percent", numberJson(point.x)}, {"frame_ms", numberJson(point.y)}};
                               })},
          {"tickOverLive", list(of.tickOverLive, [](const CurvePoint& point) {
             return Json{{"live", numberJson(point.x)}, {"tick_ms", numberJson(point.y)}};
           })}};
}

Json caseJson(const Case& of) {
  return {{"enemies", of.enemies},
          {"contenders", list(of.contenders, contenderJson)},
          {"speedUps", list(of.speedUps, [](const SpeedUp& speedUp) {
             return Json{{"contender", speedUp.contender},
                         {"upkeepAndGathering", estimate(speedUp.upkeepAndGathering)},
                         {"tick", estimate(speedUp.tick)},
                         {"frame", estimate(speedUp.frame)}};
           })}};
}

Json growthJson(const Growth& of) {
  Json fit;
  if (of.fit) {
    fit = {{"factor_ms", numberJson(of.fit->factor)},
           {"exponent", numberJson(of.fit->exponent)},
           {"r2", numberJson(of.fit->r2)}};
  }
  return {{"contender", of.contender}, {"fit", std::move(fit)}, {"why", of.why}};
}

}  // namespace

std::string reportJson(const Report& report) {
  const Json json = {{"gpuwarsProfile", kReportVersion},
                     {"machine", machine(report.machine)},
                     {"setup", setup(report.setup)},
                     {"metrics", table()},
                     {"cases", list(report.cases, caseJson)},
                     {"growth", list(report.growth, growthJson)},
                     {"stageTimersCost", numberJson(report.stageTimersCost)},
                     {"warnings", report.warnings}};
  // Names of files may hold any bytes; JSON may not.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace gw::profile
