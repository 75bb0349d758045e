// A command line in plain data: what --help, man pages and completion are made from.
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
  size_t least = 0, most = 1;  // how often it is given
  bool valueOptional = false;  // the option may stand alone
};

// The headings of --help; an option may name another.
inline constexpr const char* kOptionsGroup = "Options";
inline constexpr const char* kFilesGroup = "Files";

// Every verb takes these.
inline const std::vector<OptionText> kHelpOptions = {
    {"-h,--help", "", "print this help and exit", kOptionsGroup},
    {"--version", "", "print the version and exit", kOptionsGroup},
};

struct VerbText {
  std::string name, summary;
  std::vector<OptionText> options;  // in the order of --help, which adds kHelpOptions
};

struct NamedText {
  std::string name, text;
};

// What belongs to the program and not to one of its verbs.
struct ProgramText {
  std::string name;                     // "gpuwars"
  std::string version;                  // what --version prints
  std::string title, summary;           // "GpuWars", "a twin-stick shooter"
  std::string verbHint;                 // a remedy for a first argument that is no verb
  std::string filePattern;              // of the files that verbs take: "*.gwr"
  std::vector<std::string> paragraphs;  // of the man page
  std::vector<NamedText> files, environment;
  std::vector<NamedText> exitCodes;
};

}  // namespace gw
