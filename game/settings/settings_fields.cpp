#include "game/settings/settings_fields.h"

namespace gw {

namespace {

constexpr SettingsField number(const char* section, const char* key, const char* label, float most,
                               float* (*get)(Settings&)) {
  return {section, key, label, get, most, nullptr};
}

constexpr SettingsField flag(const char* section, const char* key, const char* label, bool* (*get)(Settings&)) {
  return {section, key, label, nullptr, 0, get};
}

constexpr SettingsField kFields[] = {
    number("sound", "effects", "sound effects", 1, [](Settings& s) { return &s.sound.effects; }),
    number("sound", "music", "music", 1, [](Settings& s) { return &s.sound.music; }),
    flag("sound", "muted", "mute all", [](Settings& s) { return &s.sound.muted; }),
    number("effects", "shake", "screen shake", 1, [](Settings& s) { return &s.effects.shake; }),
    number("effects", "flash", "flashes", 1, [](Settings& s) { return &s.effects.flash; }),
    number("effects", "glow", "glow", 1, [](Settings& s) { return &s.effects.glow; }),
    flag("effects", "particles", "particles", [](Settings& s) { return &s.effects.particles; }),
    flag("effects", "grid_bending", "grid bending", [](Settings& s) { return &s.effects.gridBending; }),
    flag("effects", "score_pops", "score pops", [](Settings& s) { return &s.effects.scorePops; }),
    // A stick that must go all the way would be no stick.
    number("pad", "move_dead_zone", "dead zone, move stick", 0.9f, [](Settings& s) { return &s.pad.moveDeadZone; }),
    number("pad", "aim_dead_zone", "dead zone, aim stick", 0.9f, [](Settings& s) { return &s.pad.aimDeadZone; }),
    flag("video", "fullscreen", "fullscreen", [](Settings& s) { return &s.fullscreen; }),
    flag("video", "keep_pointer", "keep the pointer in play", [](Settings& s) { return &s.keepPointer; }),
};

}  // namespace

std::span<const SettingsField> settingsFields() {
  return kFields;
}

}  // namespace gw
