#include "game/profile/report/report_html.h"

#include "game/profile/report/html_templates.h"
#include "game/profile/report/number_text.h"
#include "game/profile/report/report_tables.h"
#include "game/profile/report/summary.h"
#include "host/platform/markup_text.h"
#include "reportTemplate.h"

namespace gw::profile {

namespace {

const HtmlTemplates& templates() {
  static const HtmlTemplates templates(reportTemplate);  // report_template.html
  return templates;
}

std::string listOf(const std::vector<std::string>& sentences) {
  std::string html;
  for (const std::string& sentence : sentences) {
    html += templates().fill("sentence", {{"sentence", xmlEscaped(sentence)}});
  }
  return html;
}

std::string figures(std::span<const Plot> plots, std::optional<size_t> ofCase, std::string_view name = "") {
  std::string html;
  for (const Plot& plot : plots) {
    if (plot.ofCase != ofCase || !plot.name.starts_with(name)) continue;
    html += templates().fill("figure", {{"svg", plot.svg}, {"caption", xmlEscaped(plot.caption)}});
  }
  return html;
}

std::string warnings(const Report& report) {
  return report.warnings.empty() ? "" : templates().fill("warnings", {{"sentences", listOf(report.warnings)}});
}

std::string links(const Report& report) {
  std::string html;
  for (size_t i = 0; i < report.cases.size(); ++i) {
    html += templates().fill("link", {{"index", std::to_string(i)}, {"enemies", enemiesText(report.cases[i].enemies)}});
  }
  return html;
}

std::string runs(const Case& of) {
  std::string html;
  for (const Contender& contender : of.contenders) {
    html += templates().fill("runs", {{"contender", xmlEscaped(contender.name)},
                                      {"count", plural(contender.runs.size(), "run")},
                                      {"table", runTable(contender)}});
  }
  return html;
}

std::string cases(const Report& report, std::span<const Plot> plots) {
  std::string html;
  for (size_t i = 0; i < report.cases.size(); ++i) {
    const Case& of = report.cases[i];
    html += templates().fill("case", {{"index", std::to_string(i)},
                                      {"enemies", enemiesText(of.enemies)},
                                      {"contenders", contenderTable(of)},
                                      {"metrics", metricTable(of)},
                                      {"figures", figures(plots, i)},
                                      {"stages", stageTable(of)},
                                      {"runs", runs(of)}});
  }
  return html;
}

std::string speedUps(const Report& report, std::span<const Plot> plots) {
  std::string html = figures(plots, {}, "speed_ups");
  for (const Case& of : report.cases) html += speedUpTable(of);
  return html;
}

std::string growthSection(const Report& report, std::span<const Plot> plots) {
  return figures(plots, {}, "tick_over_live") + (report.growth.empty() ? "" : growthTable(report));
}

}  // namespace

std::string reportHtml(const Report& report, std::span<const Plot> plots) {
  return templates().fill("page", {{"scene", report.setup.scene.empty() ? "session" : xmlEscaped(report.setup.scene)},
                                   {"about", xmlEscaped(report.setup.about)},
                                   {"summary", listOf(summaryOf(report))},
                                   {"warnings", warnings(report)},
                                   {"links", links(report)},
                                   {"machine", machineTable(report.machine)},
                                   {"setup", setupTable(report)},
                                   {"speed-ups", speedUps(report, plots)},
                                   {"growth", growthSection(report, plots)},
                                   {"cases", cases(report, plots)},
                                   {"definitions", definitionList()}});
}

}  // namespace gw::profile
