#include "game/settings/settings_lines.h"

#include <fmt/format.h>

#include "game/settings/settings_fields.h"
#include "host/input/control_names.h"

namespace gw {

namespace {

std::string listText(InputDevice device, const std::vector<uint16_t>& codes) {
  std::string names;
  for (const uint16_t code : codes) {
    std::string name;
    for (const char c : controlName({device, code})) {
      if (c == '"' || c == '\\') name += '\\';
      name += c;
    }
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", name);
  }
  return fmt::format("[{}]", names);
}

}  // namespace

std::vector<SettingsLine> settingsLines(const Settings& settings) {
  Settings values = settings;
  std::vector<SettingsLine> lines;
  for (const SettingsField& field : settingsFields()) {
    lines.push_back({field.section, field.key,
                     field.flag ? fmt::format("{}", *field.flag(values)) : fmt::format("{}", *field.number(values))});
  }
  for (uint32_t device = 0; device < kInputDevices; ++device) {
    for (uint32_t action = 0; action < kActions; ++action) {
      lines.push_back({kBindingSections[device], std::string(actionName(Action(action))),
                       listText(InputDevice(device), values.bindings.codes(InputDevice(device), Action(action)))});
    }
  }
  return lines;
}

Settings mergedSettings(const Settings& file, const Settings& before, const Settings& now) {
  Settings merged = file, old = before, wanted = now;
  for (const SettingsField& field : settingsFields()) {
    if (field.flag) {
      if (*field.flag(old) != *field.flag(wanted)) *field.flag(merged) = *field.flag(wanted);
    } else if (*field.number(old) != *field.number(wanted)) {
      *field.number(merged) = *field.number(wanted);
    }
  }
  for (uint32_t device = 0; device < kInputDevices; ++device) {
    for (uint32_t action = 0; action < kActions; ++action) {
      const auto& codes = wanted.bindings.codes(InputDevice(device), Action(action));
      if (codes == old.bindings.codes(InputDevice(device), Action(action))) continue;
      merged.bindings.codes(InputDevice(device), Action(action)) = codes;
    }
  }
  return merged;
}

}  // namespace gw
