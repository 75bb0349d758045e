#include "game/ui/key_hints.h"

#include <algorithm>
#include <array>

#include "host/input/control_names.h"
#include "host/input/key_labels.h"

namespace gw {

namespace {

std::string first(const Bindings& bindings, InputDevice device, Action action, const char* none) {
  const std::vector<uint16_t>& codes = bindings.codes(device, action);
  return codes.empty() ? none : controlLabel({device, codes.front()});
}

// Four keys as one word: "WASD", "ARROWS", else "KEYPAD 8, KEYPAD 4, ...".
std::string together(const std::array<std::string, 4>& labels) {
  std::string letters, list;
  bool single = true;
  for (const std::string& label : labels) {
    single &= label.size() == 1;
    letters += label;
    list += (list.empty() ? "" : ", ") + label;
  }
  if (list == "UP, LEFT, DOWN, RIGHT") return "ARROWS";
  return single ? letters : list;
}

std::string cross(const Bindings& bindings, Action up, Action left, Action down, Action right) {
  const auto label = [&](Action action) { return first(bindings, InputDevice::keyboard, action, "-"); };
  return together({label(up), label(left), label(down), label(right)});
}

void nameViewerKeys(KeyHints& hints) {
  const auto label = [](uint16_t code) { return controlLabel({InputDevice::keyboard, code}); };
  hints.stepOn = label(kViewerStepOn);
  hints.stepBack = label(kViewerStepBack);
  // The viewer takes these two by what is printed on them as well (viewer_keys.cpp).
  hints.faster = layoutHas('+') ? "+" : label(kViewerFaster);
  if (hints.faster == "=") hints.faster = "+";  // that key with Shift
  hints.slower = layoutHas('-') ? "-" : label(kViewerSlower);
  hints.camera = label(kViewerCamera);
  hints.help = label(kViewerHelp);
  hints.ship = label(kViewerShip);
  hints.pan = together({label(kViewerPan[0]), label(kViewerPan[1]), label(kViewerPan[2]), label(kViewerPan[3])});
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return text;
}

std::string otherWaysToConfirm(const Bindings& bindings) {
  std::string text;
  if (!bindings.codes(InputDevice::mouse, Action::confirm).empty()) text = "or click";
  const std::vector<uint16_t>& keys = bindings.codes(InputDevice::keyboard, Action::confirm);
  if (keys.size() > 1) text += (text.empty() ? "or " : ", or ") + lower(controlLabel({InputDevice::keyboard, keys[1]}));
  return text;
}

}  // namespace

KeyHints keyHints(const Bindings& given, bool pad) {
  const Bindings bindings = withFallBacks(given);
  const auto key = [&](Action action, const char* none) {
    const std::string name = first(bindings, InputDevice::keyboard, action, none);
    return pad ? first(bindings, InputDevice::pad, action, name.c_str()) : name;
  };
  KeyHints hints;
  hints.move = cross(bindings, Action::moveUp, Action::moveLeft, Action::moveDown, Action::moveRight);
  hints.aim = cross(bindings, Action::aimUp, Action::aimLeft, Action::aimDown, Action::aimRight);
  if (!bindings.codes(InputDevice::mouse, Action::fire).empty()) hints.aim += " or MOUSE";
  hints.confirmToo = otherWaysToConfirm(bindings);
  if (pad) {
    hints.move = "LEFT STICK";
    hints.aim = "RIGHT STICK";
    hints.confirmToo.clear();
  }
  hints.flush = key(Action::flush, "-");
  hints.pause = key(Action::pause, "ESC");
  hints.confirm = key(Action::confirm, pad ? "A" : "ENTER");  // what menus always take
  hints.retry = key(Action::retry, "-");
  hints.quit = key(Action::quit, "-");
  hints.settings = key(Action::settings, "-");
  hints.spawn = key(Action::spawn, "-");
  hints.clear = key(Action::clear, "-");
  hints.more = key(Action::more, "-");
  hints.fewer = key(Action::fewer, "-");
  hints.slowMotion = key(Action::slowMotion, "-");
  hints.fullscreen = first(bindings, InputDevice::keyboard, Action::fullscreen, "-");
  hints.mute = first(bindings, InputDevice::keyboard, Action::mute, "-");
  nameViewerKeys(hints);
  return hints;
}

}  // namespace gw
