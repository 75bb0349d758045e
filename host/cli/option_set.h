// The options of one command. CLI11 splits the arguments into options and values; this writes the help, converts the
// values, applies the rules among options, and reports what is wrong in one sentence with a remedy. So neither help nor
// sentences depend on CLI11's version, and an unknown option is reported before a broken rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/cli/command_text.h"
#include "host/platform/user_error.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace gw {

// A command line that is refused.
struct UsageError : UserError {
  explicit UsageError(const std::string& sentence) : UserError(ExitCode::badUsage, sentence) {}
};

// One of the words an option takes.
template <class Value>
struct Choice {
  std::string_view name;
  Value value;
};

// The word that stands for `value`; ends in a zero, as the literals of the table do.
template <class Value, size_t kCount>
constexpr const char* wordFor(const Choice<Value> (&choices)[kCount], Value value) {
  for (const Choice<Value>& choice : choices) {
    if (choice.value == value) return choice.name.data();
  }
  return "?";
}

class OptionSet {
 public:
  using Path = std::filesystem::path;

  // `command` as sentences show it: "gpuwars diff".
  OptionSet(std::string command, const std::string& version);
  ~OptionSet();
  OptionSet(const OptionSet&) = delete;
  OptionSet& operator=(const OptionSet&) = delete;

  // Each declares an option. read() stores what was given in `value`, which must live until then and is left alone
  // where nothing was given.
  void flag(const char* name, const char* help, bool& value, const char* group = kOptionsGroup);
  void flag(const char* name, const char* help, std::function<void()> take, const char* group = kOptionsGroup);
  // `usual`: what holds without the option, as the help shows it. `choices` is a table that outlives this.
  template <class Word, size_t kCount, class Value>
  void choice(const char* name, const Choice<Word> (&choices)[kCount], const char* help, const char* usual,
              Value& value, const char* group = kOptionsGroup) {
    std::vector<std::string_view> words;
    for (const Choice<Word>& each : choices) words.push_back(each.name);
    word(
        name, words, help, usual, [&choices, &value](size_t index) { value = choices[index].value; }, group);
  }
  // Value: an integer or an optional one.
  template <class Value>
  void integer(const char* name, const char* help, uint64_t least, uint64_t most, Value& value,
               const char* group = kOptionsGroup) {
    integerMultiple(name, help, least, most, 1, value, group);
  }
  // A multiple of `step`.
  template <class Value>
  void integerMultiple(const char* name, const char* help, uint64_t least, uint64_t most, uint64_t step, Value& value,
                       const char* group = kOptionsGroup) {
    wholeNumber(
        name, help, least, most, step,
        [&value](uint64_t read) { value = static_cast<typename Held<Value>::Type>(read); }, group);
  }
  void number(const char* name, const char* help, double least, double most, double& value);
  void path(const char* name, const char* help, const char* placeholder, Path& value,
            const char* group = kOptionsGroup);
  // A path that may be left out: "-" then.
  void pathOrStdout(const char* name, const char* help, const char* placeholder, Path& value);
  // Any text, unchanged.
  void text(const char* name, const char* help, const char* placeholder, std::function<void(const std::string&)> take);
  // Arguments that are no options: one file, or `least` to `most` of them.
  void file(const char* placeholder, const char* help, Path& value);
  void files(const char* placeholder, const char* help, size_t least, size_t most, std::vector<Path>& value);

  // Rules for options declared before. A refusal of both begins with "'NAME' RELATION 'OTHER'".
  void require(const char* name);
  void exclude(const char* name, const char* relation, const char* other);
  void need(const char* name, const char* other);

  // All that was declared, in that order.
  std::vector<OptionText> described() const;
  bool knows(const std::string& option) const;

  // What `--help` prints.
  std::string help(std::string_view summary) const;

  enum class Request { run, help, version };
  // Finds the options in `arguments`. Throws UsageError.
  Request parse(std::vector<std::string> arguments);
  // What no option took, in order.
  std::vector<std::string> remaining() const;
  // After parse(): stores every value, in the order of declaration, then applies the rules. Throws UsageError.
  void read() const;

 private:
  template <class Value>
  struct Held {
    using Type = Value;
  };
  template <class Value>
  struct Held<std::optional<Value>> {
    using Type = Value;
  };
  struct Rule {
    CLI::Option *option, *other;
    bool together;  // `option` needs the other, else excludes it
    std::string refusal;
  };
  struct Entry {
    OptionText text;
    CLI::Option* option;
    std::function<void(const std::string&)> take;
    std::string name() const;   // as messages show it
    std::string shown() const;  // as help() shows it: names and placeholder
  };

  void word(const char* name, const std::vector<std::string_view>& words, const char* help, const char* usual,
            std::function<void(size_t)> take, const char* group);
  void wholeNumber(const char* name, const char* help, uint64_t least, uint64_t most, uint64_t step,
                   std::function<void(uint64_t)> take, const char* group);
  void declare(const char* names, const std::string& help, const std::string& placeholder, const char* group,
               OptionText::Value value, std::function<void(const std::string&)> take);
  void takeFiles(const char* placeholder, const char* help, size_t least, size_t most,
                 std::function<void(const std::string&)> take);
  Entry& entryOf(std::string_view name);
  void checkCount(const Entry& entry, const std::vector<std::string>& texts) const;

  std::unique_ptr<CLI::App> app_;
  std::string command_;
  std::vector<Entry> entries_;
  std::vector<Rule> rules_;
};

}  // namespace gw
