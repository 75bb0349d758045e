#include "host/input/key_labels.h"

#include <SDL.h>

#include <algorithm>

#include "host/input/control_names.h"
#include "host/input/key_names.h"

namespace gw {

namespace {

// The keys of letters, digits and signs; 100 is beside the left Shift.
constexpr uint16_t kFirstSign = SDL_SCANCODE_A, kLastSign = SDL_SCANCODE_SLASH, kOneMore = SDL_SCANCODE_NONUSBACKSLASH;

bool canBeWritten(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

bool isLetterOrDigit(const std::string& name) {
  const char c = name.front();
  return name.size() == 1 && ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'));
}

bool onAnyKey(const std::string& name, const KeyLayout& layout) {
  for (uint16_t code = kFirstSign; code <= kLastSign; ++code) {
    if (layout(code) == name) return true;
  }
  return layout(kOneMore) == name;
}

}  // namespace

std::string nameOnLayout(uint16_t code) {
  if (SDL_WasInit(SDL_INIT_VIDEO) == 0) return std::string(keyName(code));
  const char* name = SDL_GetKeyName(SDL_GetKeyFromScancode(SDL_Scancode(code)));
  return name ? name : "";
}

std::string keyLabel(uint16_t code, const KeyLayout& layout) {
  const std::string name = layout(code);
  if (canBeWritten(name)) return name;
  const std::string place = controlName({InputDevice::keyboard, code});
  if (place.size() > 1 || (isLetterOrDigit(place) && !onAnyKey(place, layout))) return place;
  return "US " + place;
}

bool layoutHas(char character, const KeyLayout& layout) {
  return onAnyKey(std::string(1, character), layout);
}

}  // namespace gw
