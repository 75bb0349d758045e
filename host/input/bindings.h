// Which key, mouse button and pad button does what, as data. Knows nothing of SDL, so that builds without a
// window can carry it; control_names.h has the names.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace gw {

enum class Action : uint32_t {
  // Held.
  moveUp,
  moveDown,
  moveLeft,
  moveRight,
  // Held; aims and fires in 8 directions.
  aimUp,
  aimDown,
  aimLeft,
  aimRight,
  // Held.
  fire,
  flush,
  // Pressed.
  pause,
  confirm,
  retry,
  quit,
  settings,
  fullscreen,
  mute,
  // Pressed; in practice only.
  spawn,
  clear,
  nextType,
  more,
  fewer,
  slowMotion,
  count
};
inline constexpr uint32_t kActions = uint32_t(Action::count);

// "move_up", as the settings file spells it.
std::string_view actionName(Action action);

enum class InputDevice : uint32_t { keyboard, mouse, pad, count };
inline constexpr uint32_t kInputDevices = uint32_t(InputDevice::count);

// Pad buttons are SDL_GameControllerButton numbers; triggers count as buttons of their own.
inline constexpr uint16_t kPadA = 0, kPadB = 1, kPadX = 2, kPadY = 3, kPadBack = 4, kPadStart = 6, kPadLeftStick = 7,
                          kPadRightStick = 8, kPadLeftShoulder = 9, kPadRightShoulder = 10, kPadUp = 11, kPadDown = 12,
                          kPadLeft = 13, kPadRight = 14;
inline constexpr uint16_t kPadLeftTrigger = 30, kPadRightTrigger = 31;
inline constexpr uint32_t kPadButtons = 32;
inline constexpr uint32_t kKeys = 512;         // SDL_NUM_SCANCODES
inline constexpr uint32_t kMouseButtons = 16;  // numbered from 1

inline constexpr uint16_t kKeyEnter = 40, kKeyEscape = 41;
// Keys of the instruments (docs/guide/overlay.md): F3, F4, F5. They are fixed, and nothing can be bound to them.
inline constexpr uint16_t kKeyOverlay = 60, kKeyColouring = 61, kKeyBroadPhase = 62;
constexpr bool isInstrumentKey(uint32_t key) {
  return key >= kKeyOverlay && key <= kKeyBroadPhase;
}

// Keys of the replay viewer (docs/guide/watching.md). They are fixed as well: . , = - C H 0 of a US keyboard, and WASD.
inline constexpr uint16_t kViewerStepOn = 55, kViewerStepBack = 54, kViewerFaster = 46, kViewerSlower = 45,
                          kViewerCamera = 6, kViewerHelp = 11, kViewerShip = 39;
inline constexpr uint16_t kViewerPan[] = {26, 4, 22, 7};  // up, left, down, right

// Something a hand can press.
struct Control {
  InputDevice device;
  // Keyboard: an SDL scancode (a USB usage number): a place on the board, so that WASD stays a cross on every
  // layout. Mouse: 1 left, 2 middle, 3 right. Pad: see above.
  uint16_t code;

  friend bool operator==(const Control&, const Control&) = default;
};

struct Bindings {
  // What does what unless it was changed.
  Bindings();

  std::vector<uint16_t>& codes(InputDevice device, Action action) { return of[uint32_t(device)][uint32_t(action)]; }
  const std::vector<uint16_t>& codes(InputDevice device, Action action) const {
    return of[uint32_t(device)][uint32_t(action)];
  }
  bool has(Control control, Action action) const;

  // Several controls may do one thing, and one control several: space flushes in play and starts on the title.
  std::array<std::array<std::vector<uint16_t>, kActions>, kInputDevices> of;

  friend bool operator==(const Bindings&, const Bindings&) = default;
};
// More for one action and device make no sense, and a damaged file must not make them either.
inline constexpr size_t kMaxControls = 8;

// No one may be locked out of the pause: where it has no key it gets Escape, where it has no pad button Start.
Bindings withFallBacks(Bindings bindings);

}  // namespace gw
