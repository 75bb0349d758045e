#include "game/settings/settings_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "game/settings/settings_fields.h"
#include "game/settings/settings_lines.h"
#include "host/input/control_names.h"
#include "host/platform/toml_library.h"

namespace gw {

namespace {

// Longer lines are refused: they bound how deep dotted keys can nest. Eight keys of the longest names fit.
constexpr size_t kMaxLine = 1000;

// The first line that is longer than kMaxLine; 0: none.
size_t tooLongLine(const std::string& text) {
  size_t line = 1, length = 0;
  for (const char c : text) {
    length = c == '\n' ? 0 : length + 1;
    if (length > kMaxLine) return line;
    line += c == '\n';
  }
  return 0;
}

// What a file holds may be anything: a message stays one line of bearable length.
std::string oneLine(std::string text) {
  constexpr size_t kMost = 120;
  if (text.size() > kMost) text = text.substr(0, kMost) + "...";
  std::replace_if(
      text.begin(), text.end(), [](char c) { return uint8_t(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

std::string keyText(std::string_view key) {
  const auto bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (!key.empty() && std::all_of(key.begin(), key.end(), bare)) return std::string(key);
  std::ostringstream stream;
  stream << toml::value<std::string>(std::string(key));
  std::string text = stream.str();
  if (text.starts_with("'''") || text.starts_with("\"\"\"")) {  // no key may be written in this way
    text = "\"";
    for (const char c : key)
      text += uint8_t(c) < 0x20 || c == '"' || c == '\\' ? fmt::format("\\u{:04x}", uint8_t(c)) : std::string(1, c);
    text += '"';
  }
  return text;
}

// As TOML, on one line if TOML can. Lists and tables are put together here: toml++ measures what it lays out, turning
// the logarithm of a number, -2 for 0.01, into an unsigned one.
std::string inlineText(const toml::node& node) {
  std::string text;
  const auto add = [&](const std::string& item) { text += (text.empty() ? " " : ", ") + item; };
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) add(fmt::format("{} = {}", keyText(key.str()), inlineText(value)));
    return text.empty() ? "{}" : fmt::format("{{{} }}", text);
  }
  if (const toml::array* list = node.as_array()) {
    for (const toml::node& item : *list) add(inlineText(item));
    return text.empty() ? "[]" : fmt::format("[{} ]", text);
  }
  // The shortest text of a number: toml++ would make 0.69999999999999996 of 0.7.
  if (const auto* number = node.as_floating_point()) {
    text = fmt::format("{}", number->get());
    return text.find_first_of(".en") == text.npos ? text + ".0" : text;
  }
  std::ostringstream stream;
  node.visit([&](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) stream << value;
  });
  return stream.str();
}

class Reader {
 public:
  Reader(const toml::table& document, const std::string& name, ReadSettings& result)
      : document_(document), name_(name), result_(result) {}

  void read() {
    for (const SettingsField& field : settingsFields()) readField(field);
    for (uint32_t device = 0; device < kInputDevices; ++device) {
      for (uint32_t action = 0; action < kActions; ++action) readControls(InputDevice(device), Action(action));
    }
    readUnknown();
  }

 private:
  // Null when the file does not have it. A section that is none is named once, by readUnknown().
  const toml::node* find(const std::string& section, std::string_view key) const {
    const toml::table* table = document_[section].as_table();
    return table ? table->get(key) : nullptr;
  }

  void complain(const toml::node& node, const std::string& key, const std::string& what) {
    result_.complaints.push_back(fmt::format("{}, line {}, {}: {}.", name_,
                                             std::max<uint32_t>(1, node.source().begin.line), oneLine(key), what));
  }
  void wrong(const toml::node& node, const std::string& key, const std::string& what) {
    complain(node, key, what);
    result_.damaged = true;
    result_.wrong.push_back(key);
  }

  void readField(const SettingsField& field) {
    const toml::node* node = find(field.section, field.key);
    if (!node) return;
    const std::string key = fmt::format("{}.{}", field.section, field.key);
    if (field.flag) {
      bool& flag = *field.flag(result_.settings);
      if (const auto* value = node->as_boolean()) {
        flag = value->get();
      } else {
        wrong(*node, key,
              fmt::format("{} is not true or false; {} is used, correct or delete the line", oneLine(inlineText(*node)),
                          flag));
      }
      return;
    }
    float& number = *field.number(result_.settings);
    const std::optional<double> value = node->is_number() ? node->value<double>() : std::nullopt;
    // Compared as it is kept: 0.9 as a double is more than 0.9 as a float. Huge ones do not fit a float at all.
    if (value && *value >= 0 && *value < 2 && float(*value) <= field.most) {
      number = float(*value);
    } else {
      wrong(*node, key,
            fmt::format("{} is not a number from 0 to {}; {} is used, correct or delete the line",
                        oneLine(inlineText(*node)), field.most, number));
    }
  }

  void readControls(InputDevice device, Action action) {
    const std::string section = kBindingSections[uint32_t(device)];
    const toml::node* node = find(section, actionName(action));
    if (!node) return;
    const std::string key = fmt::format("{}.{}", section, actionName(action));
    std::vector<uint16_t>& codes = result_.settings.bindings.codes(device, action);
    const toml::array* list = node->as_array();
    if (!list) {
      wrong(*node, key,
            fmt::format("{} is not a list of names; the default is used, write names in brackets",
                        oneLine(inlineText(*node))));
      return;
    }
    std::vector<uint16_t> named;
    for (const toml::node& item : *list) {
      const auto* text = item.as_string();
      const std::optional<Control> control = text ? controlFromName(device, text->get()) : std::nullopt;
      if (!control) {
        wrong(item, key,
              fmt::format("{} is not the name of a {}; it is left out, see docs/guide/settings.md for the names",
                          oneLine(inlineText(item)), kind(device)));
      } else if (device == InputDevice::keyboard && isInstrumentKey(control->code)) {
        wrong(item, key,
              fmt::format("{} shows how the game is computed and nothing else; it is left out, name another key",
                          oneLine(inlineText(item))));
      } else if (std::find(named.begin(), named.end(), control->code) != named.end()) {
        wrong(item, key, fmt::format("{} stands there twice; once is enough", oneLine(inlineText(item))));
      } else if (named.size() == kMaxControls) {
        wrong(item, key,
              fmt::format("{} is one too many and left out; keep at most {}", oneLine(inlineText(item)), kMaxControls));
      } else {
        named.push_back(control->code);
      }
    }
    if (named.empty() && !list->empty()) {
      complain(*node, key, "none of its names is known; the default is used, correct or delete the line");
      return;
    }
    codes = named;
  }

  static const char* kind(InputDevice device) {
    return device == InputDevice::keyboard ? "key" : device == InputDevice::mouse ? "mouse button" : "pad button";
  }

  static bool known(const std::string& section, std::string_view key) {
    for (const SettingsField& field : settingsFields()) {
      if (section == field.section && key == field.key) return true;
    }
    const bool bindings =
        std::find(std::begin(kBindingSections), std::end(kBindingSections), section) != std::end(kBindingSections);
    for (uint32_t i = 0; bindings && i < kActions; ++i) {
      if (key == actionName(Action(i))) return true;
    }
    return false;
  }

  static bool knownSection(std::string_view section) {
    const auto same = [&](const char* name) { return section == name; };
    const auto fields = settingsFields();
    return std::any_of(std::begin(kBindingSections), std::end(kBindingSections), same) ||
           std::any_of(fields.begin(), fields.end(),
                       [&](const SettingsField& field) { return section == field.section; });
  }

  void keep(const std::string& section, std::string_view key, const toml::node& node) {
    complain(node, section.empty() ? std::string(key) : fmt::format("{}.{}", section, key),
             "the key is not known; it is ignored, correct or delete it");
    const std::string line = fmt::format("{} = {}", keyText(key), inlineText(node));
    unknownSize_ += line.size();
    if (tooLongLine(line) != 0 || unknownSize_ > kMaxSettingsText / 2) {
      result_.damaged = true;  // what would be refused the next time is kept beside the file instead
    } else {
      result_.unknown.emplace_back(section, line);
    }
  }

  void readUnknown() {
    for (const auto& [key, node] : document_) {
      const std::string section(key.str());
      const toml::table* table = node.as_table();
      if (!knownSection(section)) {
        keep("", section, node);
      } else if (!table) {
        wrong(node, section,
              fmt::format("{} is not a table; its defaults are used, write it as [{}]", oneLine(inlineText(node)),
                          section));
      } else {
        for (const auto& [inner, value] : *table) {
          if (!known(section, inner.str())) keep(section, inner.str(), value);
        }
      }
    }
  }

  const toml::table& document_;
  const std::string& name_;
  ReadSettings& result_;
  size_t unknownSize_ = 0;
};

}  // namespace

ReadSettings readSettings(const std::string& text, const std::string& name) {
  ReadSettings result;
  const auto unreadable = [&](size_t line, const std::string& why) {
    result = {};
    result.damaged = true;
    result.complaints.push_back(
        fmt::format("{}, line {}: {}; the defaults are used, correct the line or delete the file.", name, line, why));
  };
  if (text.size() > kMaxSettingsText) {
    unreadable(1, fmt::format("the file is longer than {} bytes", kMaxSettingsText));
  } else if (const size_t line = tooLongLine(text)) {
    unreadable(line, fmt::format("the line is longer than {} characters", kMaxLine));
  } else {
    try {
      const toml::table document = parseToml(text);
      Reader(document, name, result).read();
    } catch (const TomlError& error) {
      unreadable(error.line, fmt::format("this is not TOML ({})", oneLine(error.what())));
    }
  }
  return result;
}

std::string writeSettings(const Settings& settings, const std::vector<std::pair<std::string, std::string>>& unknown) {
  std::string text =
      "# GpuWars. The settings screen changes this file; docs/guide/settings.md says what each key means.\n";
  const auto addUnknown = [&](std::string_view section) {
    for (const auto& [where, line] : unknown) {
      if (where == section) text += line + "\n";
    }
  };
  addUnknown("");
  std::string open;
  for (const SettingsLine& line : settingsLines(settings)) {
    if (open != line.section) {
      if (!open.empty()) addUnknown(open);
      open = line.section;
      text += fmt::format("\n[{}]\n", open);
    }
    text += fmt::format("{} = {}\n", line.key, line.value);
  }
  addUnknown(open);
  return text;
}

}  // namespace gw
