#include "host/platform/junit_xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "host/platform/markup_text.h"

namespace gw {

namespace {

using Result = JunitCase::Result;

// pugixml escapes, but writes bytes that are no characters as they are.
void set(pugi::xml_node node, const char* attribute, const std::string& value) {
  node.append_attribute(attribute) = profile::xmlCharacters(value).c_str();
}

std::string secondsText(double seconds) {
  return fmt::format("{:.6f}", seconds);
}

std::string countText(const std::vector<JunitCase>& cases, Result result) {
  return std::to_string(std::count_if(cases.begin(), cases.end(), [&](const auto& c) { return c.result == result; }));
}

void append(pugi::xml_node suite, const JunitCase& test) {
  pugi::xml_node node = suite.append_child("testcase");
  set(node, "classname", test.className);
  set(node, "name", test.name);
  set(node, "time", secondsText(test.seconds));
  if (test.result == Result::passed) return;
  pugi::xml_node why = node.append_child(test.result == Result::failure ? "failure" : "error");
  set(why, "message", test.message);
  why.text() = profile::xmlCharacters(test.text).c_str();
}

}  // namespace

std::string junitXml(const std::string& suite, const std::vector<JunitCase>& cases) {
  double seconds = 0;
  for (const JunitCase& test : cases) seconds += test.seconds;
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node root = document.append_child("testsuite");
  set(root, "name", suite);
  set(root, "tests", std::to_string(cases.size()));
  set(root, "failures", countText(cases, Result::failure));
  set(root, "errors", countText(cases, Result::error));
  set(root, "time", secondsText(seconds));
  for (const JunitCase& test : cases) append(root, test);
  std::ostringstream xml;
  document.save(xml, "  ", pugi::format_indent, pugi::encoding_utf8);
  return xml.str();
}

}  // namespace gw
