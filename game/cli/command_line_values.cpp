#include "game/cli/command_line_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace gw {
namespace {

// 1,000,000 rather than 1000000, whatever the locale.
std::string grouped(uint64_t value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (size_t i = 0; i < digits.size(); ++i) {
    if (i && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

// "--jobs" of "-j,--jobs".
std::string longName(std::string_view names) {
  return std::string(names.substr(names.find("--")));
}

constexpr const char* kFilesGroup = "Files";

// In front of every value, so that CLI11 finds nothing in it to interpret: it takes "[a,b]" for a list and drops "++".
constexpr char kValue = '\x01';

// Where the value begins in an argument; npos: it is an option without one.
size_t valueIn(const std::string& argument) {
  if (!argument.starts_with("-")) return 0;
  const size_t equals = argument.starts_with("--") ? argument.find('=') : std::string::npos;
  return equals == std::string::npos || equals + 1 == argument.size() ? std::string::npos : equals + 1;
}

std::string marked(std::string argument) {
  const size_t at = valueIn(argument);
  return at == std::string::npos ? argument : argument.insert(at, 1, kValue);
}

std::string unmarked(std::string argument) {
  const size_t at = valueIn(argument);
  return at < argument.size() && argument[at] == kValue ? argument.erase(at, 1) : argument;
}

template <class T>
std::optional<T> parsed(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::string CommandLineValues::Entry::name() const {
  return option->get_positional() ? text.names : longName(text.names);
}

std::string CommandLineValues::Entry::shown() const {
  if (text.value == OptionText::Value::none || text.value == OptionText::Value::files) return text.names;
  const std::string value = text.valueOptional ? fmt::format("[{}]", text.placeholder) : text.placeholder;
  return fmt::format("{} {}", text.names, value);
}

void CommandLineValues::declare(const char* names, const std::string& help, const std::string& placeholder,
                                const char* group, OptionText::Value value,
                                std::function<void(const std::string&)> take) {
  CLI::Option* option = app_.add_option_function<std::string>(names, [](const std::string&) {});
  option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  entries_.push_back({{names, placeholder, help, group, value}, option, std::move(take)});
}

void CommandLineValues::flag(const char* name, const char* help, std::function<void()> take, const char* group) {
  CLI::Option* option = app_.add_flag(std::string(name))->disable_flag_override();
  entries_.push_back({{name, "", help, group, OptionText::Value::none, SIZE_MAX},
                      option,
                      [take = std::move(take)](const std::string&) { take(); }});
}

void CommandLineValues::choice(const char* name, std::span<const Choice> choices, const char* help,
                               const char* standard, std::function<void(uint32_t)> take, const char* group) {
  std::string now;
  for (const Choice& c : choices) {
    if (!now.empty()) now += '|';
    now += c.name;
  }
  const auto read = [name = std::string(name), now, choices, take = std::move(take)](const std::string& text) {
    for (const Choice& c : choices) {
      if (c.name == text) return take(c.value);
    }
    throw UsageError(fmt::format("'{} {}' is not known; choose {}", name, text, now));
  };
  declare(name, fmt::format("{} ({})", help, standard), now, group, OptionText::Value::word, read);
}

void CommandLineValues::integer(const char* name, const char* help, uint64_t least, uint64_t most,
                                std::function<void(uint64_t)> take, const char* group) {
  const auto read = [=, name = longName(name), take = std::move(take)](const std::string& text) {
    const auto value = parsed<uint64_t>(text);
    if (!value || *value < least || *value > most) {
      throw UsageError(fmt::format("'{} {}' does not work; give a whole number from {} to {}", name, text,
                                   grouped(least), grouped(most)));
    }
    take(*value);
  };
  declare(name, help, "N", group, OptionText::Value::number, read);
}

void CommandLineValues::number(const char* name, const char* help, double least, double most,
                               std::function<void(double)> take) {
  const auto read = [=, name = std::string(name), take = std::move(take)](const std::string& text) {
    const auto value = parsed<double>(text);
    if (!value || !(*value >= least && *value <= most)) {
      throw UsageError(fmt::format("'{} {}' does not work; give a number from {} to {}", name, text, least, most));
    }
    take(*value);
  };
  declare(name, help, "X", kUsualGroup, OptionText::Value::number, read);
}

void CommandLineValues::path(const char* name, const char* help, const char* placeholder,
                             std::function<void(std::string)> take, const char* group) {
  const auto read = [name = std::string(name), take = std::move(take)](const std::string& text) {
    if (text.empty()) throw UsageError(fmt::format("'{}' has an empty name; give it a file name", name));
    if (text.starts_with("--")) {
      throw UsageError(
          fmt::format("'{}' is followed by '{}' where its file name should be; give it one ('./{}' if it "
                      "is really called so)",
                      name, text, text));
    }
    take(text);
  };
  declare(name, help, placeholder, group, OptionText::Value::path, read);
}

void CommandLineValues::text(const char* name, const char* help, const char* placeholder,
                             std::function<void(std::string)> take) {
  declare(name, help, placeholder, kUsualGroup, OptionText::Value::text, std::move(take));
}

void CommandLineValues::pathOrStdout(const char* name, const char* help, const char* placeholder,
                                     std::function<void(std::string)> take) {
  path(name, help, placeholder, std::move(take));
  Entry& entry = entries_.back();
  entry.option->expected(0, 1);
  entry.text.valueOptional = true;
  entry.take = [takePath = std::move(entry.take)](const std::string& text) { takePath(text.empty() ? "-" : text); };
}

void CommandLineValues::files(const char* placeholder, const char* help, size_t most,
                              std::function<void(std::string)> take) {
  CLI::Option* option =
      app_.add_option_function<std::vector<std::string>>(placeholder, [](const std::vector<std::string>&) {});
  option->expected(0, -1);  // any number
  entries_.push_back({{placeholder, placeholder, help, kFilesGroup, OptionText::Value::files, most},
                      option,
                      [take = std::move(take)](const std::string& text) {
                        if (text.empty()) throw UsageError("a file name is empty; give the file's name");
                        take(text);
                      }});
}

std::vector<OptionText> CommandLineValues::described() const {
  std::vector<OptionText> texts;
  for (const Entry& entry : entries_) texts.push_back(entry.text);
  return texts;
}

std::string CommandLineValues::help(std::string_view summary) const {
  constexpr size_t kColumn = 30;  // where descriptions begin
  std::string files, text;
  std::vector<std::string> groups{kFilesGroup, kUsualGroup};
  for (const Entry& entry : entries_) {
    const std::string& group = entry.text.group;
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
    if (group != kFilesGroup) continue;
    files = " " + entry.shown();
    if (entry.text.most == 2) files += files;
    if (entry.text.most > 2) files += "...";
  }
  if (files.empty()) groups.erase(groups.begin());
  const auto add = [&](const std::string& shown, const std::string& what) {
    const bool fits = shown.size() + 2 < kColumn;
    text +=
        "  " + shown + (fits ? "" : "\n") + std::string(fits ? kColumn - 2 - shown.size() : kColumn, ' ') + what + "\n";
  };
  for (const std::string& group : groups) {
    text += "\n" + group + ":\n";
    if (group == kUsualGroup) {
      for (const OptionText& option : kHelpOptions) add(option.names, option.help);
    }
    for (const Entry& entry : entries_) {
      if (entry.text.group == group) add(entry.shown(), entry.text.help);
    }
  }
  return fmt::format("{}\nUsage: gpuwars {} [OPTIONS]{}\n{}", summary, verb_, files, text);
}

void CommandLineValues::parse(std::vector<std::string> arguments) {
  std::transform(arguments.begin(), arguments.end(), arguments.begin(), marked);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  try {
    app_.parse(arguments);
  } catch (const CLI::Success&) {
    throw;
  } catch (const CLI::ParseError& error) {
    explain(error);
  }
}

std::vector<std::string> CommandLineValues::remaining() const {
  std::vector<std::string> left = app_.remaining();
  std::transform(left.begin(), left.end(), left.begin(), unmarked);
  return left;
}

void CommandLineValues::read() const {
  for (const Entry& entry : entries_) {
    std::vector<std::string> texts = entry.option->results();
    std::transform(texts.begin(), texts.end(), texts.begin(), unmarked);
    const size_t most = entry.text.most;
    if (texts.size() > most) {
      if (entry.option->get_positional()) {
        throw UsageError(
            fmt::format("'{}' is one file too many; give just {}", texts[most], most == 1 ? "one" : "two"));
      }
      throw UsageError(fmt::format("'{}' is given more than once; keep one of them", entry.name()));
    }
    for (const std::string& text : texts) entry.take(text);
  }
}

void CommandLineValues::explain(const CLI::ParseError& error) const {
  std::string what = error.what();
  std::erase(what, kValue);
  const std::string name = what.substr(0, what.find_first_of(": "));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    if (what.find("override") != std::string::npos) {
      throw UsageError(fmt::format("'--{}' takes no value; leave out what follows its '='", name));
    }
    throw UsageError(fmt::format("'{}' needs a value; see 'gpuwars {} --help'", name, verb_));
  }
  throw UsageError(fmt::format("the command line is not understood ({}); see 'gpuwars {} --help'", what, verb_));
}

}  // namespace gw
