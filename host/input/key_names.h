// The names of keys in the settings file: those of SDL 2.26, as a table of our own. Other versions of SDL name more
// keys and some differently, and a file must mean the same keys to all of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/input/bindings.h"

namespace gw {

// "W", "Left Shift"; empty: the key has none, and goes by its number.
std::string_view keyName(uint16_t code);

// The name that only later versions of SDL have: understood, never written. Empty: none.
std::string laterKeyName(uint16_t code);

}  // namespace gw
