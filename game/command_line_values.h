// Reads the values of options: CLI11 finds them and writes the help, this turns their text into numbers
// and choices, and says what is wrong in one sentence with a remedy.
#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gw {

// One sentence with a remedy.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// One of the words an option takes.
struct Choice {
  std::string_view name;
  uint32_t value;
};

class CommandLineValues {
 public:
  // Both must outlive this.
  CommandLineValues(CLI::App& app, std::string verb) : app_(app), verb_(std::move(verb)) {}

  // Each declares an option; `take` gets its value when read() finds one.
  void flag(const char* name, const char* help, std::function<void()> take, const char* group = "Options");
  void choice(const char* name, std::span<const Choice> choices, const char* help, const char* standard,
              std::function<void(uint32_t)> take, const char* group = "Options");
  void integer(const char* name, const char* help, uint64_t least, uint64_t most, std::function<void(uint64_t)> take,
               const char* group = "Options");
  void number(const char* name, const char* help, double least, double most, std::function<void(double)> take);
  void path(const char* name, const char* help, const char* placeholder, std::function<void(std::string)> take,
            const char* group = "Options");
  // Anything at all, taken as it is.
  void text(const char* name, const char* help, const char* placeholder, std::function<void(std::string)> take);
  // A path that may be left out: "-" then.
  void pathOrStdout(const char* name, const char* help, const char* placeholder, std::function<void(std::string)> take);
  // What stands without a dash: 1 to `most` files.
  void files(const char* placeholder, const char* help, size_t most, std::function<void(std::string)> take);

  // After parsing: hands every value over, in the order of declaration. Throws UsageError.
  void read() const;

  // What CLI11 could not parse, in our words.
  [[noreturn]] void explain(const CLI::ParseError& error) const;

 private:
  struct Entry {
    std::string name;  // as messages show it
    CLI::Option* option;
    std::function<void(const std::string&)> take;
    size_t most;  // values
  };
  CLI::Option* declare(const char* names, const char* help, const char* placeholder, const char* group,
                       std::function<void(const std::string&)> take);

  CLI::App& app_;
  std::string verb_;
  std::vector<Entry> entries_;
};

}  // namespace gw
