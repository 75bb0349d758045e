#include "host/input/control_names.h"

#include <SDL_gamecontroller.h>
#include <SDL_scancode.h>

#include <algorithm>

#include "host/input/key_labels.h"
#include "host/input/key_names.h"

namespace gw {

static_assert(kKeys == SDL_NUM_SCANCODES);
static_assert(kPadStart == SDL_CONTROLLER_BUTTON_START && kPadRight == SDL_CONTROLLER_BUTTON_DPAD_RIGHT);
static_assert(kPadLeftTrigger >= SDL_CONTROLLER_BUTTON_MAX, "triggers must not share numbers with buttons");
static_assert(kKeyEnter == SDL_SCANCODE_RETURN && kKeyEscape == SDL_SCANCODE_ESCAPE);

namespace {

constexpr std::string_view kMouseNames[] = {"", "left", "middle", "right", "x1", "x2"};

// Codes of a device run from the first to below the second.
struct Range {
  uint32_t first, end;
};
constexpr Range rangeOf(InputDevice device) {
  if (device == InputDevice::keyboard) return {1, kKeys};
  if (device == InputDevice::mouse) return {1, kMouseButtons};
  return {0, kPadButtons};
}

std::string numbered(Control control) {
  return (control.device == InputDevice::keyboard ? "Key " : "Button ") + std::to_string(control.code);
}

// Empty when there is none.
std::string ownName(Control control) {
  const char* name = nullptr;
  switch (control.device) {
    case InputDevice::keyboard:
      return std::string(keyName(control.code));
    case InputDevice::mouse:
      return control.code < std::size(kMouseNames) ? std::string(kMouseNames[control.code]) : "";
    case InputDevice::pad:
      if (control.code == kPadLeftTrigger) {
        name = SDL_GameControllerGetStringForAxis(SDL_CONTROLLER_AXIS_TRIGGERLEFT);
      } else if (control.code == kPadRightTrigger) {
        name = SDL_GameControllerGetStringForAxis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT);
      } else if (control.code < SDL_CONTROLLER_BUTTON_MAX) {
        name = SDL_GameControllerGetStringForButton(SDL_GameControllerButton(control.code));
      }
      break;
    case InputDevice::count:
      break;
  }
  return name ? name : "";
}

bool sameIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; };
    return lower(x) == lower(y);
  });
}

}  // namespace

std::string controlName(Control control) {
  const std::string own = ownName(control);
  return own.empty() ? numbered(control) : own;
}

std::optional<Control> controlFromName(InputDevice device, std::string_view name) {
  const Range range = rangeOf(device);
  for (uint32_t code = range.first; code < range.end; ++code) {
    const Control control{device, uint16_t(code)};
    if (sameIgnoringCase(name, controlName(control))) return control;
    if (device != InputDevice::keyboard) continue;
    const std::string later = laterKeyName(control.code);
    if (!later.empty() && sameIgnoringCase(name, later)) return control;
  }
  return std::nullopt;
}

std::string controlLabel(Control control) {
  if (control.device == InputDevice::pad) {
    constexpr std::string_view kShort[] = {"A",     "B",      "X",        "Y",        "BACK",
                                           "GUIDE", "START",  "L STICK",  "R STICK",  "LB",
                                           "RB",    "PAD UP", "PAD DOWN", "PAD LEFT", "PAD RIGHT"};
    if (control.code == kPadLeftTrigger) return "LT";
    if (control.code == kPadRightTrigger) return "RT";
    if (control.code < std::size(kShort)) return std::string(kShort[control.code]);
  }
  std::string label = control.device == InputDevice::keyboard ? keyLabel(control.code) : controlName(control);
  if (label == "Escape") label = "Esc";
  if (label == "Return") label = "Enter";
  std::transform(label.begin(), label.end(), label.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
  if (control.device == InputDevice::mouse && control.code <= 3) return std::string(1, label[0]) + "MB";
  const auto shorten = [&](std::string_view from, std::string_view to) {
    if (label.starts_with(from) && label.size() > from.size()) label.replace(0, from.size(), to);
  };
  shorten("LEFT ", "L ");
  shorten("RIGHT ", "R ");
  shorten("KEYPAD ", "KP ");
  return label;
}

std::string controlLabels(const Bindings& bindings, InputDevice device, Action action) {
  std::string text;
  for (const uint16_t code : bindings.codes(device, action)) {
    if (!text.empty()) text += ", ";
    text += controlLabel({device, code});
  }
  return text.empty() ? "-" : text;
}

}  // namespace gw
