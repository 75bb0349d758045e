#include "game/profile/report/report_html.h"

#include <fmt/format.h>

#include "game/profile/report/number_text.h"
#include "game/profile/report/report_tables.h"
#include "game/profile/report/summary.h"
#include "host/platform/markup_text.h"

namespace gw::profile {

namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --page: #f4f6f8; --card: #ffffff; --ink: #1c2128; --faint: #59636e; --line: #d8dde3;
  --accent: #0067a5; --best: #e3f1e8; --warn: #fff4d6; --warn-edge: #c78a00; }
@media screen and (prefers-color-scheme: dark) {
  :root { --page: #0d1117; --card: #161b22; --ink: #e8ecf1; --faint: #9aa5b1; --line: #313a45; --accent: #6cb6ff;
    --best: #17382a; --warn: #33290f; --warn-edge: #e0a526; }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink); font: 15px/1.5 "DejaVu Sans", Verdana, sans-serif; }
header, main, footer { max-width: 1060px; margin: 0 auto; padding: 0 24px; }
header { padding-top: 32px; }
h1 { margin: 0; font-size: 28px; line-height: 1.25; overflow-wrap: anywhere; }
h2 { margin: 44px 0 12px; font-size: 21px; }
h3 { margin: 26px 0 10px; font-size: 16px; }
a { color: var(--accent); text-decoration: none; }
a:hover, a:focus { text-decoration: underline; }
.kind { margin: 0 0 4px; color: var(--faint); letter-spacing: .06em; text-transform: uppercase; font-size: 12px; }
.about, .note, figcaption, small { color: var(--faint); }
.summary { margin: 20px 0; padding: 16px 20px; background: var(--card); border: 1px solid var(--line);
  border-left: 5px solid var(--accent); border-radius: 8px; font-size: 17px; list-style: none; }
.summary li + li { margin-top: 8px; }
.warnings { margin: 20px 0; padding: 12px 20px; background: var(--warn); border: 1px solid var(--warn-edge);
  border-left-width: 5px; border-radius: 8px; }
.warnings h2 { margin: 0; font-size: 16px; }
.warnings ul { margin: 6px 0 0; padding-left: 20px; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(440px, 100%), 1fr)); gap: 16px;
  align-items: start; }
.wide { overflow-x: auto; margin: 14px 0; background: var(--card); border: 1px solid var(--line); border-radius: 8px; }
table { border-collapse: collapse; width: 100%; font-size: 14px; }
caption { padding: 10px 14px; text-align: left; font-weight: bold; }
caption small { font-weight: normal; }
th, td { padding: 6px 14px; border-top: 1px solid var(--line); text-align: left; vertical-align: top; }
th { font-weight: normal; color: var(--faint); }
thead th { font-weight: bold; color: var(--ink); }
.numbers td { font-variant-numeric: tabular-nums; white-space: nowrap; }
.numbers th, .names th { white-space: nowrap; }
td strong { padding: 1px 5px; margin-left: -5px; background: var(--best); border-radius: 4px; }
.unknown { color: var(--faint); font-style: italic; }
code { font-family: "DejaVu Sans Mono", monospace; font-size: 13px; }
figure { margin: 18px 0; overflow-x: auto; }
figure svg { display: block; width: 100%; min-width: 640px; height: auto; }
figcaption { margin-top: 6px; font-size: 14px; }
details { margin: 10px 0; }
summary { cursor: pointer; color: var(--accent); }
nav ul { display: flex; flex-wrap: wrap; gap: 6px 18px; margin: 16px 0 0; padding: 0; list-style: none; }
dt { margin-top: 12px; font-weight: bold; }
dt small { font-weight: normal; }
dd { margin: 2px 0 0; }
footer { margin-top: 48px; padding-bottom: 32px; color: var(--faint); font-size: 13px; }
)";

std::string listOf(const std::vector<std::string>& sentences) {
  std::string html;
  for (const std::string& sentence : sentences) html += "<li>" + xmlEscaped(sentence) + "</li>\n";
  return html;
}

std::string figures(std::span<const Plot> plots, std::optional<size_t> ofCase, std::string_view name = "") {
  std::string html;
  for (const Plot& plot : plots) {
    if (plot.ofCase != ofCase || !plot.name.starts_with(name)) continue;
    html += "<figure>\n" + plot.svg + "<figcaption>" + xmlEscaped(plot.caption) + "</figcaption>\n</figure>\n";
  }
  return html;
}

std::string navigation(const Report& report) {
  std::string html =
      "<nav aria-label=\"Sections\"><ul>\n<li><a href=\"#machine\">Machine</a></li>\n"
      "<li><a href=\"#speed-ups\">Speed-ups</a></li>\n<li><a href=\"#growth\">Growth</a></li>\n";
  for (size_t i = 0; i < report.cases.size(); ++i) {
    html += fmt::format("<li><a href=\"#case-{}\">{}</a></li>\n", i, enemiesText(report.cases[i].enemies));
  }
  return html + "<li><a href=\"#metrics\">Definitions</a></li>\n</ul></nav>\n";
}

std::string caseSection(const Case& of, size_t index, std::span<const Plot> plots) {
  std::string html = fmt::format("<section aria-labelledby=\"case-{0}\">\n<h2 id=\"case-{0}\">{1}</h2>\n", index,
                                 enemiesText(of.enemies));
  html += contenderTable(of) + metricTable(of) + figures(plots, index) + stageTable(of);
  for (const Contender& contender : of.contenders) {
    html += fmt::format("<details><summary>{}: {}</summary>\n{}</details>\n", xmlEscaped(contender.name),
                        plural(contender.runs.size(), "run"), runTable(contender));
  }
  return html + "</section>\n";
}

std::string comparison(const Report& report, std::span<const Plot> plots) {
  std::string html = "<section aria-labelledby=\"speed-ups\">\n<h2 id=\"speed-ups\">Speed-ups</h2>\n" +
                     figures(plots, {}, "speed_ups");
  for (const Case& of : report.cases) html += speedUpTable(of);
  html +=
      "</section>\n<section aria-labelledby=\"growth\">\n<h2 id=\"growth\">Growth with the number "
      "of enemies</h2>\n" +
      figures(plots, {}, "tick_over_live");
  if (!report.growth.empty()) html += growthTable(report);
  return html + "</section>\n";
}

}  // namespace

std::string reportHtml(const Report& report, std::span<const Plot> plots) {
  const std::string scene = report.setup.scene.empty() ? "session" : xmlEscaped(report.setup.scene);
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>GpuWars profile: " +
      scene + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n";
  html += "<header>\n<p class=\"kind\">GpuWars profile</p>\n<h1>" + scene + "</h1>\n<p class=\"about\">" +
          xmlEscaped(report.setup.about) + "</p>\n<ul class=\"summary\">\n" + listOf(summaryOf(report)) + "</ul>\n";
  if (!report.warnings.empty()) {
    html += "<section class=\"warnings\" aria-labelledby=\"warnings\">\n<h2 id=\"warnings\">Warnings</h2>\n<ul>\n" +
            listOf(report.warnings) + "</ul>\n</section>\n";
  }
  html += navigation(report) + "</header>\n<main>\n";
  html += "<section aria-labelledby=\"machine\">\n<h2 id=\"machine\">Machine and session</h2>\n<div class=\"pair\">\n" +
          machineTable(report.machine) + setupTable(report) + "</div>\n</section>\n";
  html += comparison(report, plots);
  for (size_t i = 0; i < report.cases.size(); ++i) html += caseSection(report.cases[i], i, plots);
  html += "<section aria-labelledby=\"metrics\">\n<h2 id=\"metrics\">Definitions of the metrics</h2>\n" +
          definitionList() + "</section>\n</main>\n";
  return html +
         "<footer>The same figures for programs are in report.json, every frame in frames.csv, the pictures in "
         "plots.</footer>\n</body>\n</html>\n";
}

}  // namespace gw::profile
