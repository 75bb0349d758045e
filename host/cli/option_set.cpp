#include "host/cli/option_set.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <charconv>
#include <optional>

#include "host/platform/number_format.h"

namespace gw {
namespace {

// "--jobs" of "-j,--jobs".
std::string longName(std::string_view names) {
  return std::string(names.substr(names.find("--")));
}

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

[[noreturn]] void refuse(const std::string& sentence) {
  throw UsageError(sentence);
}

// What CLI11 could not parse, in our words.
std::string explained(const CLI::ParseError& error, const std::string& command) {
  std::string what = error.what();
  std::erase(what, kValue);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) {
    return fmt::format("the command line is not understood ({}); see '{} --help'", what, command);
  }
  const std::string name = what.substr(0, what.find_first_of(": "));
  if (what.find("override") != std::string::npos) {
    return fmt::format("'--{}' takes no value; leave out what follows its '='", name);
  }
  return fmt::format("'{}' needs a value; see '{} --help'", name, command);
}

}  // namespace

OptionSet::OptionSet(std::string command, const std::string& version)
    : app_(std::make_unique<CLI::App>()), command_(std::move(command)) {
  app_->set_version_flag("--version", version);
  app_->allow_extras();  // so that the caller can say where they belong
}

OptionSet::~OptionSet() = default;

std::string OptionSet::Entry::name() const {
  return option->get_positional() ? text.names : longName(text.names);
}

std::string OptionSet::Entry::shown() const {
  if (text.value == OptionText::Value::none || text.value == OptionText::Value::files) return text.names;
  const std::string value = text.valueOptional ? fmt::format("[{}]", text.placeholder) : text.placeholder;
  return fmt::format("{} {}", text.names, value);
}

void OptionSet::declare(const char* names, const std::string& help, const std::string& placeholder, const char* group,
                        OptionText::Value value, std::function<void(const std::string&)> take) {
  CLI::Option* option = app_->add_option_function<std::string>(names, [](const std::string&) {});
  option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  entries_.push_back({{names, placeholder, help, group, value}, option, std::move(take)});
}

void OptionSet::flag(const char* name, const char* help, bool& value, const char* group) {
  flag(
      name, help, [&value] { value = true; }, group);
}

void OptionSet::flag(const char* name, const char* help, std::function<void()> take, const char* group) {
  CLI::Option* option = app_->add_flag(std::string(name))->disable_flag_override();
  entries_.push_back({{name, "", help, group, OptionText::Value::none, 0, SIZE_MAX},
                      option,
                      [take = std::move(take)](const std::string&) { take(); }});
}

void OptionSet::word(const char* name, const std::vector<std::string_view>& words, const char* help, const char* usual,
                     std::function<void(size_t)> take, const char* group) {
  std::string list;
  for (const std::string_view each : words) list.append(list.empty() ? "" : "|").append(each);
  const auto read = [name = std::string(name), list, words, take = std::move(take)](const std::string& text) {
    const auto found = std::find(words.begin(), words.end(), text);
    if (found == words.end()) refuse(fmt::format("'{} {}' is not known; choose {}", name, text, list));
    take(size_t(found - words.begin()));
  };
  declare(name, fmt::format("{} ({})", help, usual), list, group, OptionText::Value::word, read);
}

void OptionSet::wholeNumber(const char* name, const char* help, uint64_t least, uint64_t most, uint64_t step,
                            std::function<void(uint64_t)> take, const char* group) {
  const auto read = [=, name = longName(name), take = std::move(take)](const std::string& text) {
    const auto value = parsed<uint64_t>(text);
    if (!value || *value < least || *value > most) {
      refuse(fmt::format("'{} {}' is not valid; give a whole number from {} to {}", name, text, withCommas(least),
                         withCommas(most)));
    }
    if (*value % step != 0) {
      refuse(fmt::format("'{} {}' is not valid; give a multiple of {} from {} to {}", name, text, step,
                         withCommas(least), withCommas(most)));
    }
    take(*value);
  };
  declare(name, help, "N", group, OptionText::Value::number, read);
}

void OptionSet::number(const char* name, const char* help, double least, double most, double& value) {
  const auto read = [=, &value, name = std::string(name)](const std::string& text) {
    const auto given = parsed<double>(text);
    if (!given || !(*given >= least && *given <= most)) {
      refuse(fmt::format("'{} {}' is not valid; give a number from {} to {}", name, text, least, most));
    }
    value = *given;
  };
  declare(name, help, "X", kOptionsGroup, OptionText::Value::number, read);
}

void OptionSet::path(const char* name, const char* help, const char* placeholder, Path& value, const char* group) {
  const auto read = [name = std::string(name), &value](const std::string& text) {
    if (text.empty()) refuse(fmt::format("'{}' has an empty name; give it a file name", name));
    if (text.starts_with("--")) {
      refuse(fmt::format("'{}' is followed by '{}' instead of a file name; add one ('./{}' if that is the file's name)",
                         name, text, text));
    }
    value = text;
  };
  declare(name, help, placeholder, group, OptionText::Value::path, read);
}

void OptionSet::pathOrStdout(const char* name, const char* help, const char* placeholder, Path& value) {
  path(name, help, placeholder, value);
  Entry& entry = entries_.back();
  entry.option->expected(0, 1);
  entry.text.valueOptional = true;
  entry.take = [takePath = std::move(entry.take)](const std::string& text) { takePath(text.empty() ? "-" : text); };
}

void OptionSet::text(const char* name, const char* help, const char* placeholder,
                     std::function<void(const std::string&)> take) {
  declare(name, help, placeholder, kOptionsGroup, OptionText::Value::text, std::move(take));
}

void OptionSet::file(const char* placeholder, const char* help, Path& value) {
  takeFiles(placeholder, help, 1, 1, [&value](const std::string& text) { value = text; });
}

void OptionSet::files(const char* placeholder, const char* help, size_t least, size_t most, std::vector<Path>& value) {
  takeFiles(placeholder, help, least, most, [&value](const std::string& text) { value.emplace_back(text); });
}

void OptionSet::takeFiles(const char* placeholder, const char* help, size_t least, size_t most,
                          std::function<void(const std::string&)> take) {
  CLI::Option* option =
      app_->add_option_function<std::vector<std::string>>(placeholder, [](const std::vector<std::string>&) {});
  option->expected(0, -1);  // any number: checkCount() has the sentences
  entries_.push_back({{placeholder, placeholder, help, kFilesGroup, OptionText::Value::files, least, most},
                      option,
                      [take = std::move(take)](const std::string& text) {
                        if (text.empty()) refuse("a file name is empty; give the file's name");
                        take(text);
                      }});
}

OptionSet::Entry& OptionSet::entryOf(std::string_view name) {
  return *std::find_if(entries_.begin(), entries_.end(), [&](const Entry& each) { return each.name() == name; });
}

void OptionSet::require(const char* name) {
  entryOf(name).text.least = 1;
}

void OptionSet::exclude(const char* name, const char* relation, const char* other) {
  rules_.push_back({entryOf(name).option, entryOf(other).option, false,
                    fmt::format("'{}' {} '{}'; leave out one of the two", name, relation, other)});
}

void OptionSet::need(const char* name, const char* other) {
  const Entry& needed = entryOf(other);
  rules_.push_back(
      {entryOf(name).option, needed.option, true, fmt::format("'{}' needs '{}'; add it", name, needed.shown())});
}

std::vector<OptionText> OptionSet::described() const {
  std::vector<OptionText> texts;
  for (const Entry& entry : entries_) texts.push_back(entry.text);
  return texts;
}

std::string OptionSet::help(std::string_view summary) const {
  constexpr size_t kColumn = 30;  // where descriptions begin
  std::string files, text;
  std::vector<std::string> groups{kFilesGroup, kOptionsGroup};
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
    if (group == kOptionsGroup) {
      for (const OptionText& option : kHelpOptions) add(option.names, option.help);
    }
    for (const Entry& entry : entries_) {
      if (entry.text.group == group) add(entry.shown(), entry.text.help);
    }
  }
  return fmt::format("{}\nUsage: {} [OPTIONS]{}\n{}", summary, command_, files, text);
}

bool OptionSet::knows(const std::string& option) const {
  return app_->get_option_no_throw(option) != nullptr;
}

OptionSet::Request OptionSet::parse(std::vector<std::string> arguments) {
  std::transform(arguments.begin(), arguments.end(), arguments.begin(), marked);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  try {
    app_->parse(arguments);
  } catch (const CLI::CallForVersion&) {
    return Request::version;
  } catch (const CLI::Success&) {
    return Request::help;
  } catch (const CLI::ParseError& error) {
    refuse(explained(error, command_));
  }
  return Request::run;
}

std::vector<std::string> OptionSet::remaining() const {
  std::vector<std::string> left = app_->remaining();
  std::transform(left.begin(), left.end(), left.begin(), unmarked);
  return left;
}

void OptionSet::read() const {
  for (const Entry& entry : entries_) {
    std::vector<std::string> texts = entry.option->results();
    std::transform(texts.begin(), texts.end(), texts.begin(), unmarked);
    checkCount(entry, texts);
    for (const std::string& text : texts) entry.take(text);
  }
  for (const Rule& rule : rules_) {
    if (rule.option->count() > 0 && (rule.other->count() > 0) != rule.together) refuse(rule.refusal);
  }
}

void OptionSet::checkCount(const Entry& entry, const std::vector<std::string>& texts) const {
  const auto& [names, placeholder, help, group, value, least, most, optional] = entry.text;
  const bool files = value == OptionText::Value::files;
  if (texts.size() < least && files) {
    refuse(fmt::format("'{}' needs {} ({}); add {}", command_, least == 1 ? "a file" : "two files", help,
                       least == 1 ? "its name" : "both names"));
  }
  if (texts.size() < least) refuse(fmt::format("'{}' needs '{}' ({}); add it", command_, entry.shown(), help));
  if (texts.size() <= most) return;
  if (files) refuse(fmt::format("'{}' is one file too many; give just {}", texts[most], most == 1 ? "one" : "two"));
  refuse(fmt::format("'{}' is given more than once; keep one of them", entry.name()));
}

}  // namespace gw
