#include "game/command_line_values.h"

#include <fmt/format.h>

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

template <class T>
std::optional<T> parsed(const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

CLI::Option* CommandLineValues::declare(const char* names, const char* help, const char* placeholder, const char* group,
                                        std::function<void(const std::string&)> take) {
  CLI::Option* option = app_.add_option_function<std::string>(
      names, [](const std::string&) {}, help);
  option->type_name(placeholder)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->group(group);
  entries_.push_back({longName(names), option, std::move(take), 1});
  return option;
}

void CommandLineValues::flag(const char* name, const char* help, std::function<void()> take, const char* group) {
  CLI::Option* option = app_.add_flag(std::string(name))->description(help)->disable_flag_override()->group(group);
  entries_.push_back({name, option, [take = std::move(take)](const std::string&) { take(); }, SIZE_MAX});
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
  declare(name, fmt::format("{} ({})", help, standard).c_str(), now.c_str(), group, read);
}

void CommandLineValues::integer(const char* name, const char* help, uint64_t least, uint64_t most,
                                std::function<void(uint64_t)> take, const char* group) {
  declare(name, help, "N", group, [=, name = longName(name), take = std::move(take)](const std::string& text) {
    const auto value = parsed<uint64_t>(text);
    if (!value || *value < least || *value > most) {
      throw UsageError(fmt::format("'{} {}' does not work; give a whole number from {} to {}", name, text,
                                   grouped(least), grouped(most)));
    }
    take(*value);
  });
}

void CommandLineValues::number(const char* name, const char* help, double least, double most,
                               std::function<void(double)> take) {
  declare(name, help, "X", "Options", [=, name = std::string(name), take = std::move(take)](const std::string& text) {
    const auto value = parsed<double>(text);
    if (!value || !(*value >= least && *value <= most)) {
      throw UsageError(fmt::format("'{} {}' does not work; give a number from {} to {}", name, text, least, most));
    }
    take(*value);
  });
}

void CommandLineValues::path(const char* name, const char* help, const char* placeholder,
                             std::function<void(std::string)> take, const char* group) {
  declare(name, help, placeholder, group, [name = std::string(name), take = std::move(take)](const std::string& text) {
    if (text.empty()) throw UsageError(fmt::format("'{}' has an empty name; give it a file name", name));
    if (text.starts_with("--")) {
      throw UsageError(
          fmt::format("'{}' is followed by '{}' where its file name should be; give it one ('./{}' if it "
                      "is really called so)",
                      name, text, text));
    }
    take(text);
  });
}

void CommandLineValues::text(const char* name, const char* help, const char* placeholder,
                             std::function<void(std::string)> take) {
  declare(name, help, placeholder, "Options", std::move(take));
}

void CommandLineValues::pathOrStdout(const char* name, const char* help, const char* placeholder,
                                     std::function<void(std::string)> take) {
  path(name, help, placeholder, std::move(take));
  Entry& entry = entries_.back();
  entry.option->expected(0, 1);
  entry.take = [takePath = std::move(entry.take)](const std::string& text) { takePath(text.empty() ? "-" : text); };
}

void CommandLineValues::files(const char* placeholder, const char* help, size_t most,
                              std::function<void(std::string)> take) {
  CLI::Option* option = app_.add_option_function<std::vector<std::string>>(
      placeholder, [](const std::vector<std::string>&) {}, help);
  option->type_name("")->expected(0, CLI::detail::expected_max_vector_size);
  entries_.push_back({placeholder, option,
                      [take = std::move(take)](const std::string& text) {
                        if (text.empty()) throw UsageError("a file name is empty; give the file's name");
                        take(text);
                      },
                      most});
}

void CommandLineValues::read() const {
  for (const Entry& entry : entries_) {
    const std::vector<std::string>& texts = entry.option->results();
    if (texts.size() > entry.most) {
      if (entry.option->get_positional()) {
        throw UsageError(
            fmt::format("'{}' is one file too many; give just {}", texts[entry.most], entry.most == 1 ? "one" : "two"));
      }
      throw UsageError(fmt::format("'{}' is given more than once; keep one of them", entry.name));
    }
    for (const std::string& text : texts) entry.take(text);
  }
}

void CommandLineValues::explain(const CLI::ParseError& error) const {
  const std::string what = error.what();
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
