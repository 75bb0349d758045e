// Reads the values of options: CLI11 finds them, this writes the help, turns their text into numbers and choices, and
// says what is wrong in one sentence with a remedy. So neither help nor sentences depend on CLI11's version.
#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "game/cli/command_line_text.h"
#include "host/platform/user_error.h"

namespace gw {

// One sentence with a remedy.
struct UsageError : UserError {
  explicit UsageError(const std::string& sentence) : UserError(ExitCode::badUsage, sentence) {}
};

// One of the words an option takes.
struct Choice {
  std::string_view name;
  uint32_t value;
};

class CommandLineValues {
 public:
  // The heading under which options stand in the help, unless they name another.
  static constexpr const char* kUsualGroup = "Options";

  // Both must outlive this.
  CommandLineValues(CLI::App& app, std::string verb) : app_(app), verb_(std::move(verb)) {}

  // Each declares an option; `take` gets its value when read() finds one.
  void flag(const char* name, const char* help, std::function<void()> take, const char* group = kUsualGroup);
  void choice(const char* name, std::span<const Choice> choices, const char* help, const char* standard,
              std::function<void(uint32_t)> take, const char* group = kUsualGroup);
  void integer(const char* name, const char* help, uint64_t least, uint64_t most, std::function<void(uint64_t)> take,
               const char* group = kUsualGroup);
  void number(const char* name, const char* help, double least, double most, std::function<void(double)> take);
  void path(const char* name, const char* help, const char* placeholder, std::function<void(std::string)> take,
            const char* group = kUsualGroup);
  // Anything at all, taken as it is.
  void text(const char* name, const char* help, const char* placeholder, std::function<void(std::string)> take);
  // A path that may be left out: "-" then.
  void pathOrStdout(const char* name, const char* help, const char* placeholder, std::function<void(std::string)> take);
  // What stands without a dash: 1 to `most` files.
  void files(const char* placeholder, const char* help, size_t most, std::function<void(std::string)> take);

  // All that was declared, in that order.
  std::vector<OptionText> described() const;

  // What `--help` prints.
  std::string help(std::string_view summary) const;

  // Lets the app parse. Values are as they were given: CLI11 itself takes "[a,b]" for two, and "[a]" for "a".
  void parse(std::vector<std::string> arguments);
  // What no option took, in order.
  std::vector<std::string> remaining() const;

  // After parsing: hands every value over, in the order of declaration. Throws UsageError.
  void read() const;

 private:
  struct Entry {
    OptionText text;
    CLI::Option* option;
    std::function<void(const std::string&)> take;
    std::string name() const;   // as messages show it
    std::string shown() const;  // as help() shows it: names and placeholder
  };
  void declare(const char* names, const std::string& help, const std::string& placeholder, const char* group,
               OptionText::Value value, std::function<void(const std::string&)> take);

  // What CLI11 could not parse, in our words.
  [[noreturn]] void explain(const CLI::ParseError& error) const;

  CLI::App& app_;
  std::string verb_;
  std::vector<Entry> entries_;
};

}  // namespace gw
