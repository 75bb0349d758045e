// The plain settings (settings.h) as a table, which file, screen and tests iterate over.
#pragma once

#include <span>

#include "game/settings/settings.h"

namespace gw {

// A number from 0 to `most`, or a switch; the other pointer is null.
struct SettingsField {
  const char* section;
  const char* key;
  const char* label;  // on the screen
  float* (*number)(Settings&);
  float most;
  bool* (*flag)(Settings&);
};

std::span<const SettingsField> settingsFields();

// The sections of the file that hold bindings, by InputDevice.
inline constexpr const char* kBindingSections[kInputDevices] = {"keys", "mouse", "pad_buttons"};

}  // namespace gw
