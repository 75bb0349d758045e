// What pictures say. Whether they are well-formed and full of ink is what report_files_test.py looks at.
#include "game/profile/report/plots.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "tests/game/profile/report/sample_report.h"

namespace gw::profile::test {
namespace {

const Plot& named(const std::vector<Plot>& plots, const std::string& name) {
  for (const Plot& plot : plots) {
    if (plot.name == name) return plot;
  }
  throw std::runtime_error("no picture is called " + name);
}

bool says(const Plot& plot, const std::string& text) {
  return plot.svg.find(text) != plot.svg.npos;
}

TEST(Plots, AreFiveOfEachCaseAndTwoOfAll) {
  const std::vector<Plot> plots = plotsOf(sampleReport());
  EXPECT_EQ(plots.size(), 2u + 3 * 5);
  std::set<std::string> names;
  for (const Plot& plot : plots) names.insert(plot.name);
  EXPECT_EQ(names.size(), plots.size());
  EXPECT_TRUE(names.contains("fps_over_time_16384"));
  EXPECT_EQ(named(plots, "percentiles_4096").ofCase, 1u);
  EXPECT_FALSE(named(plots, "speed_ups").ofCase.has_value());
}

TEST(Plots, AllShowHowManyEnemiesLived) {
  for (const Plot& plot : plotsOf(sampleReport())) EXPECT_TRUE(says(plot, " live")) << plot.name;
  const std::vector<Plot> plots = plotsOf(sampleReport());
  EXPECT_TRUE(says(plots[0], "1,024 to 16,384 enemies asked, "));
  EXPECT_TRUE(says(named(plots, "stages_4096"), "4,096 enemies asked, "));
}

TEST(Plots, NameWhatTheyShow) {
  const std::vector<Plot> plots = plotsOf(sampleReport());
  for (const char* kind : {"fps_over_time_1024", "frame_times_1024", "percentiles_1024", "stages_1024"}) {
    for (const char* contender : {"ngrid", "grid-hashed", "brute"}) {
      EXPECT_TRUE(says(named(plots, kind), std::string(">") + contender + "</text>")) << kind;
    }
    EXPECT_FALSE(says(named(plots, kind), "ngrid-r2")) << "in shadow there are no frames";
  }
  for (const char* kind : {"frame_times_1024", "percentiles_1024"}) {
    EXPECT_TRUE(says(named(plots, kind), "16.7 ms") && says(named(plots, kind), "33.3 ms"));
  }
  EXPECT_TRUE(says(named(plots, "fps_over_time_1024"), ">live enemies</text>")) << "on an axis of its own";
  EXPECT_TRUE(says(named(plots, "tick_over_live"), "grid-hashed: live to the power 1.06, R² 0.9971"));
  EXPECT_TRUE(says(named(plots, "speed_ups"), "1.970 (1.931 to 2.009)"));
  EXPECT_TRUE(says(named(plots, "stages_1024"), ">particles</text>"));
  EXPECT_TRUE(says(named(plots, "stages_over_time_1024"), "over time: ngrid"));
}

TEST(Plots, MoreStagesThanColoursShareTheLast) {
  Report report = sampleReport();
  Contender& first = report.cases[0].contenders[0];
  first.stages.insert(first.stages.end(), {"eleventh", "twelfth"});
  first.stages_ms.insert(first.stages_ms.end(), {5, 1e-9});
  const std::vector<Plot> plots = plotsOf(report);
  EXPECT_TRUE(says(named(plots, "stages_1024"), ">others</text>"));
  EXPECT_TRUE(says(named(plots, "stages_1024"), ">eleventh</text>"));
  EXPECT_FALSE(says(named(plots, "stages_1024"), ">twelfth</text>")) << "the cheapest";
}

TEST(Plots, OfTheSameSizeHaveNamesOfTheirOwn) {
  Report report = sampleReport();
  report.cases[1].enemies = report.cases[0].enemies;
  const std::vector<Plot> plots = plotsOf(report);
  EXPECT_EQ(named(plots, "stages_1024_2").ofCase, 1u);
}

TEST(Plots, OfNothingSaySo) {
  Report report;
  report.cases = {{8192, {}, {}}};
  const std::vector<Plot> plots = plotsOf(report);
  ASSERT_EQ(plots.size(), 7u);
  for (const Plot& plot : plots) {
    EXPECT_TRUE(says(plot, "There was nothing") || says(plot, "No ")) << plot.name;
    EXPECT_TRUE(says(plot, "8,192 enemies asked, live ones not counted")) << plot.name;
  }
}

TEST(Plots, HoldNoNumberThatIsNone) {
  for (const Plot& plot : plotsOf(hostileReport())) {
    for (const char* odd : {"\"nan", "\"inf", "\"-nan", "\"-inf", ",nan", ",inf", ",-nan", ",-inf", " nan", " -inf"}) {
      EXPECT_FALSE(says(plot, odd)) << plot.name << " " << odd;
    }
    EXPECT_FALSE(says(plot, "<script")) << plot.name;
  }
}

RC_GTEST_PROP(Plots, OfAnyReportAreMade, (uint32_t seed)) {
  for (const Plot& plot : plotsOf(randomReport(seed))) {
    RC_ASSERT(plot.svg.starts_with("<svg ") && plot.svg.ends_with("</svg>\n"));
    RC_ASSERT(!says(plot, "\"nan") && !says(plot, ",nan") && !says(plot, ",inf") && !says(plot, ",-inf"));
  }
}

}  // namespace
}  // namespace gw::profile::test
