// What is printed on a key, by the keyboard layout in use.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace gw {

// A key's name on a layout; empty: it has none, as a dead key.
using KeyLayout = std::function<std::string(uint16_t code)>;

// The layout in use now. Before there is a window, a US keyboard's.
std::string nameOnLayout(uint16_t code);

// For the screens, whose typeface has printable ASCII only. Where it cannot write the layout's name, it is the name in
// the settings file, which is a US keyboard's: as it is for letters and digits, which stand on keyboards of other
// scripts too, else, and where the layout has that name elsewhere, with "US" before it.
std::string keyLabel(uint16_t code, const KeyLayout& layout = nameOnLayout);

// Whether some key gives this character without Shift.
bool layoutHas(char character, const KeyLayout& layout = nameOnLayout);

}  // namespace gw
