// Ticks that people read, and text that fits.
#include "game/profile/report/axis.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "game/profile/report/number_text.h"
#include "game/profile/report/svg.h"
#include "host/platform/markup_text.h"

namespace gw::profile::test {
namespace {

std::string labels(const Axis& axis) {
  std::string text;
  for (const Tick& tick : axis.ticks) text += tick.label + "|";
  return text;
}

TEST(PlotAxis, LinearTicksAreRound) {
  EXPECT_EQ(labels(linearAxis("", 412)), "0|100|200|300|400|500|");
  EXPECT_EQ(labels(linearAxis("", 60, true)), "0|10|20|30|40|50|60|");
  EXPECT_EQ(labels(linearAxis("", 57, true)), "0|10|20|30|40|50|");
  EXPECT_EQ(labels(linearAxis("", 0.7)), "0|0.2|0.4|0.6|0.8|");
  EXPECT_EQ(labels(linearAxis("", 8192)), "0|2,000|4,000|6,000|8,000|10,000|");
}

TEST(PlotAxis, TheGreatestAndTheLeastNumbersHaveTicksToo) {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const Axis linear = linearAxis("", most);
  EXPECT_EQ(labels(linear), "0|5e+307|1e+308|1.5e+308|");
  EXPECT_EQ(linear.high, most);
  const Axis logarithmic = logarithmicAxis("", {least, most});
  EXPECT_GT(logarithmic.low, 0);
  EXPECT_EQ(logarithmic.high, 1e308);
  EXPECT_TRUE(std::isfinite(logarithmic.share(1)));
  EXPECT_LT(logarithmic.ticks.size(), 1000u);
}

TEST(PlotAxis, LogarithmicTicksAreOneTwoFive) {
  EXPECT_EQ(labels(logarithmicAxis("", {0.3, 40})), "0.2|0.5|1|2|5|10|20|50|");
  EXPECT_EQ(labels(logarithmicAxis("", {1, 10})), "1|2|5|10|");
  EXPECT_EQ(labels(logarithmicAxis("", {3, 3})), "2|5|");
  EXPECT_EQ(labels(logarithmicAxis("", {5, 5})), "2|5|10|");
  EXPECT_EQ(labels(logarithmicAxis("", {0.01, 1000})), "0.01|||0.1|||1|||10|||100|||1,000|");
}

TEST(PlotAxis, OfManyPowersSomeAreNamed) {
  EXPECT_EQ(labels(logarithmicAxis("", {1e-12, 1e12})), "1e-12|1e-09|1e-06|0.001|1|1,000|1,000,000|1e+09|1e+12|");
}

TEST(PlotAxis, EachNineTakesAsMuchRoom) {
  const Axis axis = ninesAxis("");
  EXPECT_DOUBLE_EQ(axis.share(0), 0);
  EXPECT_NEAR(axis.share(90), 0.25, 1e-9);
  EXPECT_NEAR(axis.share(99), 0.5, 1e-9);
  EXPECT_NEAR(axis.share(99.9), 0.75, 1e-9);
  EXPECT_NEAR(axis.share(99.99), 1, 1e-9);
  EXPECT_GT(axis.share(100), 1);
}

RC_GTEST_PROP(PlotAxis, HoldsWhatItWasMadeFor, (uint32_t a, uint32_t b, int32_t scale)) {
  const double unit = std::pow(10, scale % 12), low = (a + 1.0) * unit, high = low * (1 + b % 100000 / 10.0);
  const Axis linear = linearAxis("", high), logarithmic = logarithmicAxis("", {low, high});
  if (high > 1e-9) RC_ASSERT(linear.share(high) <= 1 + 1e-9 && linear.share(high) > 0.4);
  RC_ASSERT(linear.ticks.size() >= 3u && linear.ticks.size() <= 12u);
  RC_ASSERT(logarithmic.share(low) >= -1e-9 && logarithmic.share(high) <= 1 + 1e-9);
  RC_ASSERT(logarithmic.ticks.size() >= 2u);
}

TEST(PlotText, MarkupIsEscaped) {
  EXPECT_EQ(xmlEscaped("<a href=\"x\">'&'</a>"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(xmlEscaped("R² – 語 🎮"), "R² – 語 🎮");
}

TEST(PlotText, WhatIsNoTextIsReplaced) {
  const std::string gone = "\xEF\xBF\xBD";
  EXPECT_EQ(xmlEscaped(std::string_view("a\0b", 3)), "a" + gone + "b");
  EXPECT_EQ(xmlEscaped("\xff"), gone);
  EXPECT_EQ(xmlEscaped("\xC3"), gone) << "cut short";
  EXPECT_EQ(xmlEscaped("\xC0\xAF"), gone + gone) << "longer than needed";
  EXPECT_EQ(xmlEscaped("\xED\xA0\x80"), gone + gone + gone) << "half of a pair";
  EXPECT_EQ(xmlEscaped("\xEF\xBF\xBF"), gone + gone + gone) << "no character";
  EXPECT_EQ(xmlEscaped("\xF4\x90\x80\x80"), gone + gone + gone + gone) << "past the last";
}

TEST(PlotText, IsShortenedByCharacters) {
  EXPECT_EQ(shortened("R²R²", 4), "R²R²");
  EXPECT_EQ(shortened("R²R²R", 4), "R²R…");
  EXPECT_EQ(lengthOf(fitted(std::string(500, 'x'), 13, 100)), 12u);
}

TEST(PlotText, FiguresHaveFourDigitsThatCount) {
  EXPECT_EQ(figureText(1234567.4), "1,234,567");
  EXPECT_EQ(figureText(12.3456), "12.35");
  EXPECT_EQ(figureText(0.0123456), "0.01235");
  EXPECT_EQ(figureText(1000), "1,000");
  EXPECT_EQ(figureText(-1234.5), "-1,234");
  EXPECT_EQ(figureText(0), "0");
  EXPECT_EQ(figureText(1e300), "1.000e+300");
  EXPECT_EQ(figureText(NAN), "–");
  EXPECT_EQ(estimateText({1.97, 1.93, 2.01}), "1.970 (1.930 to 2.010)");
  EXPECT_EQ(estimateText({1.97, NAN, NAN}), "1.970");
}

}  // namespace
}  // namespace gw::profile::test
