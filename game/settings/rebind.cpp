#include "game/settings/rebind.h"

#include <algorithm>

#include "host/input/control_names.h"

namespace gw {

namespace {

bool inPlay(Action action) {
  return action <= Action::pause || action >= Action::fullscreen;
}

bool inMenus(Action action) {
  return action >= Action::pause && action <= Action::mute;
}

// Space may flush in play and start on the title; both cannot be meant at once.
bool atOnce(Action a, Action b) {
  return (inPlay(a) && inPlay(b)) || (inMenus(a) && inMenus(b));
}

}  // namespace

std::string actionLabel(Action action) {
  std::string label(actionName(action));
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

std::string rebind(Bindings& bindings, Action action, Control control, bool add) {
  std::vector<uint16_t>& own = bindings.codes(control.device, action);
  if (bindings.has(control, action) && (add || own.size() == 1)) return "";
  if (add && own.size() >= kMaxControls) {
    return actionLabel(action) + " has " + std::to_string(kMaxControls) + " already: replace them instead";
  }
  const std::vector<uint16_t> before = own;
  if (!add) own.clear();
  own.push_back(control.code);

  std::string note;
  for (uint32_t i = 0; i < kActions; ++i) {
    const Action other = Action(i);
    if (other == action || !atOnce(action, other) || !bindings.has(control, other)) continue;
    std::vector<uint16_t>& codes = bindings.codes(control.device, other);
    std::erase(codes, control.code);
    const bool swapped = codes.empty() && !add && !before.empty() && before.front() != control.code;
    if (swapped) codes.push_back(before.front());
    if (!note.empty()) note += "; ";
    note += controlLabel(control) + " was " + actionLabel(other) + ", which is now " +
            controlLabels(bindings, control.device, other);
  }
  return note;
}

}  // namespace gw
