// report.html: all that was found is on it, and nothing on it needs anything else.
#include "game/profile/report/report_html.h"

#include <gtest/gtest.h>

#include "game/profile/report/summary.h"
#include "tests/game/profile/report/sample_report.h"

namespace gw::profile::test {
namespace {

std::string pageOf(const Report& report) {
  return reportHtml(report, plotsOf(report));
}

size_t countOf(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(ReportPage, HasEveryMetricWithItsDefinition) {
  const std::string page = pageOf(sampleReport());
  for (const Metric& metric : metrics()) {
    EXPECT_EQ(countOf(page, "<dt id=\"metric-" + std::string(metric.name) + "\">"), 1u) << metric.name;
    EXPECT_GE(countOf(page, "href=\"#metric-" + std::string(metric.name) + "\""), 3u) << metric.name;
  }
}

TEST(ReportPage, HasEveryPictureAndContender) {
  const Report report = sampleReport();
  const std::string page = pageOf(report);
  EXPECT_EQ(countOf(page, "<svg "), plotsOf(report).size());
  EXPECT_EQ(countOf(page, "<details>"), 3u * 4);
  EXPECT_EQ(countOf(page, "<figcaption>"), plotsOf(report).size());
  EXPECT_NE(page.find("NGrid, exact gather, frozen rows"), std::string::npos);
  EXPECT_NE(page.find("AMD EPYC 7B13"), std::string::npos);
  EXPECT_NE(page.find(report.warnings[0]), std::string::npos);
  EXPECT_NE(page.find("5d3c1f0a99e2b704"), std::string::npos);
}

TEST(ReportPage, NeedsNothingElse) {
  const std::string page = pageOf(sampleReport());
  for (const char* outside : {"src=", "url(", "@import", "https:", "//cdn", "<script", "<iframe", "<img"}) {
    EXPECT_EQ(countOf(page, outside), 0u) << outside;
  }
  EXPECT_EQ(countOf(page, "http:"), countOf(page, "xmlns=\"http://www.w3.org/2000/svg\"")) << "a name, not an address";
}

TEST(ReportPage, IsAccessible) {
  const std::string page = pageOf(sampleReport());
  EXPECT_NE(page.find("<html lang=\"en\">"), std::string::npos);
  EXPECT_NE(page.find("<title>GpuWars profile: swarm</title>"), std::string::npos);
  EXPECT_EQ(countOf(page, "<svg "), countOf(page, "role=\"img\" aria-label=\""));
  EXPECT_EQ(countOf(page, "<table "), countOf(page, "<caption>"));
  EXPECT_EQ(countOf(page, "<th>"), 0u) << "every heading says what it heads";
  EXPECT_NE(page.find("prefers-color-scheme: dark"), std::string::npos);
}

TEST(ReportPage, NamesAreNoMarkup) {
  const std::string page = pageOf(hostileReport());
  EXPECT_EQ(countOf(page, "<script"), 0u);
  EXPECT_EQ(countOf(page, "</title>"), 1u);
  EXPECT_GT(countOf(page, "&lt;script&gt;alert(&quot;&amp;&#39;&quot;)&lt;/script&gt;"), 5u);
}

TEST(ReportPage, OfNothingIsAPage) {
  const std::string page = pageOf({});
  EXPECT_NE(page.find("Nothing was measured."), std::string::npos);
  EXPECT_TRUE(page.ends_with("</html>\n"));
}

TEST(ReportSummary, SaysRateAndSpeedUps) {
  Report report = sampleReport();
  report.cases.resize(1);
  report.setup.drawn = "nothing: simulation only";
  Contender& first = report.cases[0].contenders[0];
  first.overall["ticksPerSecond"] = {412.26, 410, 414};
  report.cases[0].speedUps.erase(report.cases[0].speedUps.begin() + 1);
  EXPECT_EQ(summaryOf(report), std::vector<std::string>{
                                   "ngrid: 412.3 ticks/s at 1,024 enemies; its tick is 1.97 times as fast as that of "
                                   "grid-hashed (95 % interval 1.93 to 2.01), its upkeep and gathering are 0.82 times "
                                   "as fast as those of ngrid-r2 (95 % interval 0.79 to 0.85)."});
  report.setup.drawn = "window 1280x720";
  first.overall["meanFps"] = {98.2, 98, 99};
  EXPECT_TRUE(summaryOf(report)[0].starts_with("ngrid: 412.3 ticks/s, 98.20 frames/s at 1,024 enemies; "));
  report.cases[0].speedUps[0].tick = {2, kUnknown, kUnknown};
  EXPECT_NE(summaryOf(report)[0].find("of grid-hashed (too few runs for an interval)"), std::string::npos);
}

}  // namespace
}  // namespace gw::profile::test
