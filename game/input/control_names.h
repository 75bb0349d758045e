// Keys and buttons by name: as the settings file spells them, and as the screens show them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "game/input/bindings.h"

namespace gw {

// Keys are named as SDL names them ("W", "Left Shift"), pad buttons too ("leftshoulder"); mouse buttons are
// left, middle, right, x1, x2. What has no name of its own is "Key 135" or "Button 7". Every control of the
// device's range has a name, and controlFromName() takes it back.
std::string controlName(Control control);
std::optional<Control> controlFromName(InputDevice device, std::string_view name);

// Short, for the screens: "W", "LMB", "L SHIFT", "LB".
std::string controlLabel(Control control);
// All of an action's controls on a device, e.g. "W, UP"; "-" when there is none.
std::string controlLabels(const Bindings& bindings, InputDevice device, Action action);

}  // namespace gw
