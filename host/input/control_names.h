// Keys and buttons by name: as the settings file spells them, and as the screens show them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/input/bindings.h"

namespace gw {

// Keys go by place, under key_names.h's names ("W", "Left Shift"); pad buttons are named as SDL names them
// ("leftshoulder"); mouse buttons are left, middle, right, x1, x2. What has no name of its own is "Key 135" or
// "Button 7". Every control of the device's range has a name, and controlFromName() takes it back.
std::string controlName(Control control);
std::optional<Control> controlFromName(InputDevice device, std::string_view name);

// Short, for the screens: "LMB", "L SHIFT", "LB"; keys as the layout in use has them (key_labels.h), so that the key
// that the file calls "W" is "Z" on a French keyboard.
std::string controlLabel(Control control);
// All of an action's controls on a device, e.g. "W, UP"; "-" when there is none.
std::string controlLabels(const Bindings& bindings, InputDevice device, Action action);

}  // namespace gw
