// Settings that differ from the defaults in every single value.
#pragma once

#include "game/settings/settings.h"

namespace gw::test {

inline Settings otherSettings() {
  Settings settings;
  settings.sound = {0.35f, 0.1f, true};
  settings.effects = {0.5f, 0, false, false, false};
  settings.pad = {0.45f, 0.9f};
  settings.video.fullscreen = true;
  settings.video.keepPointer = false;
  for (auto& device : settings.bindings.of) {
    for (uint32_t action = 0; action < kActions; ++action)
      device[action] = {uint16_t(action + 5), uint16_t(action + 6)};
  }
  // Of what a mouse has.
  for (auto& codes : settings.bindings.of[uint32_t(InputDevice::mouse)]) codes = {2, 5};
  return settings;
}

}  // namespace gw::test
