// Results of tests in the XML format of JUnit, which continuous integration reads.
#pragma once

#include <string>
#include <vector>

namespace gw {

struct JunitCase {
  enum class Result { passed, failure, error };
  std::string className, name;
  double seconds = 0;
  Result result = Result::passed;
  std::string message = {}, text = {};  // of a failure or an error: its first line, and all of it
};

std::string junitXml(const std::string& suite, const std::vector<JunitCase>& cases);

}  // namespace gw
