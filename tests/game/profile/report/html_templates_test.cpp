// Templates of the report's page: every key gets its value, and nothing is replaced twice.
#include "game/profile/report/html_templates.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gw::profile::test {
namespace {

constexpr const char* kText =
    "<!-- template list -->\n<ul>\n{{items}}</ul>\n<!-- template item -->\n<li>{{a}}{{b}}</li>\n";

TEST(HtmlTemplates, FillEachKeyWhereverItStands) {
  const HtmlTemplates templates(kText);
  EXPECT_EQ(templates.fill("item", {{"b", "2"}, {"a", "1"}}), "<li>12</li>\n");
  EXPECT_EQ(templates.fill("list", {{"items", "x\n"}}), "<ul>\nx\n</ul>\n");
}

TEST(HtmlTemplates, LeaveBracesInValuesAlone) {
  const HtmlTemplates templates(kText);
  EXPECT_EQ(templates.fill("item", {{"a", "{{b}}"}, {"b", "{{a}}"}}), "<li>{{b}}{{a}}</li>\n");
}

TEST(HtmlTemplates, RefuseWhatTheyDoNotHave) {
  const HtmlTemplates templates(kText);
  EXPECT_THROW(templates.fill("item", {{"a", "1"}}), std::logic_error);
  EXPECT_THROW(templates.fill("page", {}), std::logic_error);
}

}  // namespace
}  // namespace gw::profile::test
