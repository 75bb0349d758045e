// Giving an action another key or button.
#pragma once

#include <string>

#include "host/input/bindings.h"

namespace gw {

// As the screens say it: "move up".
std::string actionLabel(Action action);

// `action` gets `control`: instead of what it had on that device, or with `add` beside it. An action that could be
// meant by the same press at the same time gives the control up, and gets what was replaced when it would be left
// with nothing on that device. Returns a sentence about that; empty: no other action is concerned.
std::string rebind(Bindings& bindings, Action action, Control control, bool add);

}  // namespace gw
