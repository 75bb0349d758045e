// The command line as its tables declare it, in plain data: what --help, man pages and completion are made from.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gw {

struct OptionText {
  enum class Value { none, word, number, path, text, files };

  std::string names;        // "-j,--jobs"; of files their placeholder
  std::string placeholder;  // of the value: "N"; of words all of them: "on|off"; empty where there is none
  std::string help;
  std::string group;
  Value value = Value::none;
  size_t most = 1;             // values
  bool valueOptional = false;  // the option may stand alone
};

struct VerbText {
  std::string name, summary;
  std::vector<OptionText> options;  // in the order of --help, which adds kHelpOptions
};

struct ExitText {
  std::string code;  // a digit, or how it comes about
  const char* meaning;
};

// Every verb takes these.
extern const std::vector<OptionText> kHelpOptions;
extern const std::vector<ExitText> kExitTexts;

std::vector<VerbText> describeCommandLine();

}  // namespace gw
