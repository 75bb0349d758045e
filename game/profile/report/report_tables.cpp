#include "game/profile/report/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "game/profile/report/number_text.h"
#include "host/platform/markup_text.h"

namespace gw::profile {

namespace {

constexpr const char* kNotSaid = "<span class=\"unknown\">not said</span>";

// Rows of a heading and cells; what comes in is escaped already.
class Table {
 public:
  explicit Table(const std::string& caption, const char* kind = "numbers")
      : html_(fmt::format("<div class=\"wide\"><table class=\"{}\"><caption>{}</caption>\n", kind, caption)) {}

  Table& heads(const std::vector<std::string>& heads) {
    html_ += "<thead><tr>";
    for (const std::string& head : heads) html_ += "<th scope=\"col\">" + head + "</th>";
    html_ += "</tr></thead>\n";
    return *this;
  }
  void row(const std::string& head, const std::vector<std::string>& cells) {
    html_ += "<tr><th scope=\"row\">" + head + "</th>";
    for (const std::string& cell : cells) html_ += "<td>" + cell + "</td>";
    html_ += "</tr>\n";
  }
  std::string whole() const { return html_ + "</table></div>\n"; }

 private:
  std::string html_;
};

std::string textCell(const std::string& text) {
  return text.empty() ? kNotSaid : xmlEscaped(text);
}

std::string numberCell(double value, const char* unit) {
  return std::isfinite(value) ? figureText(value) + unit : kNotSaid;
}

std::string loadCell(double load) {
  return std::isfinite(load) ? fmt::format("{:.2f}", load) : kNotSaid;
}

std::string quotaCell(const std::optional<ProcessorState>& of) {
  if (!of) return kNotSaid;
  if (!std::isfinite(of->quota)) return "none";
  return fmt::format("{} processors, {}", figureText(of->quota), numberCell(of->throttled_s, " s"));
}

// Escaped, with names between backticks as code.
std::string withCode(std::string_view text) {
  std::string html;
  bool code = false;
  for (size_t end; (end = text.find('`')) != text.npos; text.remove_prefix(end + 1), code = !code) {
    html += xmlEscaped(text.substr(0, end)) + (code ? "</code>" : "<code>");
  }
  return html + xmlEscaped(text) + (code ? "</code>" : "");
}

std::string estimateCell(const Estimate& estimate, bool best = false) {
  std::string cell = figureText(estimate.value);
  if (best) cell = "<strong title=\"the best of this row\">" + cell + "</strong>";
  if (std::isfinite(estimate.low) && std::isfinite(estimate.high)) {
    cell += " <small>" + figureText(estimate.low) + " to " + figureText(estimate.high) + "</small>";
  }
  return cell;
}

// With its definition as a tooltip, and a link to it.
std::string metricHead(const Metric& metric) {
  std::string head = fmt::format("<a href=\"#metric-{0}\" title=\"{1}\">{0}</a>", xmlEscaped(metric.name),
                                 xmlEscaped(metric.definition));
  if (*metric.unit != '\0') head += fmt::format(" <small>{}</small>", xmlEscaped(metric.unit));
  return head;
}

const char* betterText(Better better) {
  switch (better) {
    case Better::higher:
      return "Higher is better.";
    case Better::lower:
      return "Lower is better.";
    case Better::neither:
      return "";
  }
  return "";
}

// Of those that have it. No best where all are alike.
double bestOf(const Case& of, const Metric& metric) {
  double best = kUnknown;
  size_t values = 0;
  bool differ = false;
  for (const Contender& contender : of.contenders) {
    const auto found = contender.overall.find(metric.name);
    if (found == contender.overall.end() || !std::isfinite(found->second.value)) continue;
    const double value = found->second.value;
    differ = differ || (values > 0 && value != best);
    if (values++ == 0 || (metric.better == Better::higher ? value > best : value < best)) best = value;
  }
  return metric.better != Better::neither && differ ? best : kUnknown;
}

std::vector<std::string> contenderHeads(const char* first, const Case& of) {
  std::vector<std::string> heads = {first};
  for (const Contender& contender : of.contenders) heads.push_back(xmlEscaped(contender.name));
  return heads;
}

}  // namespace

std::string machineTable(const Machine& of) {
  Table table("Machine", "words");
  const std::pair<const char*, const std::string&> texts[] = {
      {"Processor", of.cpu}, {"Cores", of.cores},       {"GPU", of.gpu},
      {"Driver", of.driver}, {"Renderer", of.renderer}, {"Compiler", of.compiler},
      {"Flags", of.flags},   {"Commit", of.commit},     {"System", of.system}};
  for (const auto& [head, text] : texts) table.row(head, {textCell(text)});
  const ProcessorState processors = of.processors.value_or(ProcessorState{});
  table.row("Processors allowed", {textCell(processors.allowed)});
  table.row("Quota of their time, held up by it", {quotaCell(of.processors)});
  table.row("Governor, turbo, clocks", {textCell(processors.governor) + ", " + textCell(processors.turbo) + ", " +
                                        textCell(processors.clockRange)});
  table.row("Load of one minute, before and after", {loadCell(of.loadBefore) + ", " + loadCell(of.loadAfter)});
  table.row("GPU clock, power, temperature",
            {numberCell(of.gpuClock_MHz, " MHz") + ", " + numberCell(of.gpuPower_W, " W") + ", " +
             numberCell(of.gpuTemperature_C, " °C")});
  return table.whole();
}

std::string setupTable(const Report& report) {
  const Setup& of = report.setup;
  Table table("What was measured", "words");
  const std::pair<const char*, const std::string&> texts[] = {{"Scene", of.scene}, {"What happens", of.about},
                                                              {"Mode", of.mode},   {"Device", of.device},
                                                              {"Drawn", of.drawn}, {"Pacing", of.pacing}};
  for (const auto& [head, text] : texts) table.row(head, {textCell(text)});
  table.row("Each run", {fmt::format("{}, the first {} dropped", plural(of.ticks, "tick"), wholeText(of.warmUp))});
  table.row("Runs", {wholeText(of.runs) + (of.interrupted ? " asked for; interrupted" : "")});
  table.row("Timing the stages costs",
            {std::isfinite(report.stageTimersCost) ? fmt::format("{:.1f} % of a tick", 100 * report.stageTimersCost)
                                                   : kNotSaid});
  return table.whole();
}

std::string contenderTable(const Case& of) {
  Table table("Contenders", "names");
  table.heads({"Contender", "What it is", "Runs", "Hash of the last tick"});
  for (const Contender& contender : of.contenders) {
    table.row(xmlEscaped(contender.name),
              {textCell(contender.about), wholeText(double(contender.runs.size())),
               contender.shadow ? "none: in shadow, on the positions of an exact run beside it"
                                : "<code>" + textCell(contender.hash) + "</code>"});
  }
  return table.whole();
}

std::string metricTable(const Case& of) {
  Table table("Metrics, the mean of the runs <small>and the interval that holds the true one with 95 %</small>");
  table.heads(contenderHeads("Metric", of));
  std::string missing;
  for (const Metric& metric : metrics()) {
    const double best = bestOf(of, metric);
    std::vector<std::string> cells;
    bool any = false;
    for (const Contender& contender : of.contenders) {
      const auto found = contender.overall.find(metric.name);
      const bool has = found != contender.overall.end() && std::isfinite(found->second.value);
      cells.push_back(has ? estimateCell(found->second, found->second.value == best) : "–");
      any = any || has;
    }
    if (any) {
      table.row(metricHead(metric), cells);
    } else {
      missing += (missing.empty() ? "" : ", ") + metricHead(metric);
    }
  }
  return table.whole() + (missing.empty() ? "" : "<p class=\"note\">Not measured: " + missing + ".</p>\n");
}

std::string stageTable(const Case& of) {
  std::vector<std::string> names;
  for (const Contender& contender : of.contenders) {
    for (const std::string& stage : contender.stages) {
      if (std::find(names.begin(), names.end(), stage) == names.end()) names.push_back(stage);
    }
  }
  if (names.empty()) return "";
  Table table("Stages of a tick <small>ms, the mean of the runs</small>");
  table.heads(contenderHeads("Stage", of));
  for (const std::string& name : names) {
    std::vector<std::string> cells;
    for (const Contender& contender : of.contenders) {
      const auto at =
          size_t(std::find(contender.stages.begin(), contender.stages.end(), name) - contender.stages.begin());
      cells.push_back(figureText(at < contender.stages_ms.size() ? contender.stages_ms[at] : kUnknown));
    }
    table.row(xmlEscaped(name), cells);
  }
  return table.whole();
}

std::string speedUpTable(const Case& of) {
  if (of.speedUps.empty() || of.contenders.empty()) return "";
  Table table(fmt::format("{}: how many times faster {} is <small>with the interval of 95 %</small>",
                          enemiesText(of.enemies), xmlEscaped(of.contenders[0].name)));
  table.heads({"Against", "Upkeep and gathering", "Tick", "Frame"});
  for (const SpeedUp& speedUp : of.speedUps) {
    table.row(xmlEscaped(speedUp.contender),
              {estimateCell(speedUp.upkeepAndGathering), estimateCell(speedUp.tick), estimateCell(speedUp.frame)});
  }
  return table.whole();
}

std::string runTable(const Contender& of) {
  Table table("Runs of " + xmlEscaped(of.name));
  std::vector<std::string> heads = {"Metric"};
  for (size_t run = 1; run <= of.runs.size(); ++run) heads.push_back("run " + std::to_string(run));
  table.heads(heads);
  for (const Metric& metric : metrics()) {
    std::vector<std::string> cells;
    bool any = false;
    for (const MetricValues& run : of.runs) {
      const auto found = run.find(metric.name);
      any = any || found != run.end();
      cells.push_back(figureText(found == run.end() ? kUnknown : found->second));
    }
    if (any) table.row(metricHead(metric), cells);
  }
  return table.whole();
}

std::string growthTable(const Report& report) {
  Table table("Time of a tick = factor × live<sup>exponent</sup>");
  table.heads({"Contender", "Factor <small>ms</small>", "Exponent", "R² <small>share explained</small>"});
  for (const Growth& growth : report.growth) {
    const std::string why = growth.why.empty() ? "no fit" : "no fit: " + xmlEscaped(growth.why);
    table.row(xmlEscaped(growth.contender),
              growth.fit ? std::vector<std::string>{figureText(growth.fit->factor), figureText(growth.fit->exponent),
                                                    figureText(growth.fit->r2)}
                         : std::vector<std::string>{why, "–", "–"});
  }
  return table.whole();
}

std::string definitionList() {
  std::string html = "<dl>\n";
  for (const Metric& metric : metrics()) {
    const std::string unit = *metric.unit == '\0' ? "" : " <small>" + xmlEscaped(metric.unit) + "</small>";
    html += fmt::format("<dt id=\"metric-{0}\">{0}{1}</dt><dd>{2} {3}</dd>\n", xmlEscaped(metric.name), unit,
                        withCode(metric.definition), betterText(metric.better));
  }
  return html + "</dl>\n";
}

}  // namespace gw::profile
