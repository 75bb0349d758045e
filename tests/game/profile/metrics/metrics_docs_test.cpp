// docs/guide/profile.md has the table of metrics, row by row.
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <set>

#include "game/profile/metrics/metrics.h"

namespace gw::profile {
namespace {

const char* nameOf(Better better) {
  return better == Better::higher ? "higher" : better == Better::lower ? "lower" : "";
}

std::vector<std::string> rowsOfMetrics() {
  std::vector<std::string> rows;
  for (const Metric& m : metrics()) {
    rows.push_back(std::string("| `") + m.name + "` | " + m.unit + " | " + nameOf(m.better) + " | " + m.definition +
                   " |");
  }
  return rows;
}

// The doc may align its columns.
std::string withSingleSpaces(const std::string& row) {
  std::string text;
  for (const char c : row) {
    if (c != ' ' || !text.ends_with(' ')) text += c;
  }
  return text;
}

// From below the line under its heading to the first that is none of it.
std::vector<std::string> rowsOfDoc() {
  std::ifstream doc(GW_PROFILE_DOC);
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(doc, line) && line != "| name | unit | better | definition |") {
  }
  std::getline(doc, line);
  while (std::getline(doc, line) && line.starts_with("|")) rows.push_back(withSingleSpaces(line));
  return rows;
}

TEST(Metrics, AreDefinedInTheDoc) {
  const std::vector<std::string> doc = rowsOfDoc();
  std::vector<std::string> table;
  std::string wanted;
  for (const std::string& row : rowsOfMetrics()) {
    table.push_back(withSingleSpaces(row));
    wanted += row + "\n";
  }
  EXPECT_EQ(doc, table) << "docs/guide/profile.md needs these rows:\n" << wanted;
}

TEST(Metrics, HaveNamesOfTheirOwnAndOneSentence) {
  std::set<std::string> names;
  for (const Metric& m : metrics()) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    for (const char c : std::string(m.name)) EXPECT_TRUE(std::isalnum(uint8_t(c)) || c == '_' || c == '.') << m.name;
    const std::string definition = m.definition;
    EXPECT_TRUE(definition.ends_with('.')) << m.name;
    EXPECT_EQ(definition.find(". "), std::string::npos) << m.name;
    EXPECT_EQ(&metric(m.name), &m);
  }
  EXPECT_THROW(metric("fps"), std::invalid_argument);
  EXPECT_THROW(metric(""), std::invalid_argument);
}

}  // namespace
}  // namespace gw::profile
