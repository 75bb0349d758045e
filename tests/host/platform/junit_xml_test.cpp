// The XML that continuous integration reads: elements, attributes, and any bytes in names.
#include "host/platform/junit_xml.h"

#include <gtest/gtest.h>

namespace gw::test {
namespace {

TEST(JunitXml, HasOneElementPerCaseWithItsResult) {
  using Result = JunitCase::Result;
  const std::string xml = junitXml("suite", {{"a.b", "fine", 0.5, Result::passed, "", ""},
                                             {"a.b", "bad", 0.25, Result::failure, "first", "first\nsecond\n"},
                                             {"a.b", "broken", 0, Result::error, "why", "why\n"}});
  EXPECT_EQ(xml, R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="suite" tests="3" failures="1" errors="1" time="0.750000">
  <testcase classname="a.b" name="fine" time="0.500000" />
  <testcase classname="a.b" name="bad" time="0.250000">
    <failure message="first">first
second
</failure>
  </testcase>
  <testcase classname="a.b" name="broken" time="0.000000">
    <error message="why">why
</error>
  </testcase>
</testsuite>
)");
}

TEST(JunitXml, EscapesMarkupAndReplacesWhatIsNoCharacter) {
  const std::string xml = junitXml("s", {{"c", "<&\"\xff\x01", 0, JunitCase::Result::passed, "", ""}});
  EXPECT_NE(xml.find("name=\"&lt;&amp;&quot;\uFFFD\uFFFD\""), std::string::npos) << xml;
}

}  // namespace
}  // namespace gw::test
