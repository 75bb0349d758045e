#include "game/settings/settings_fields.h"

namespace gw {

namespace {

#define GW_NUMBER_FIELD(section, member, key, initial, most, label) \
  {#section, key, label, [](Settings& s) { return &s.section.member; }, most, nullptr},
#define GW_SWITCH_FIELD(section, member, key, initial, label) \
  {#section, key, label, nullptr, 0, [](Settings& s) { return &s.section.member; }},

constexpr SettingsField kFields[] = {
    // clang-format off
    GW_SOUND_SETTINGS(GW_NUMBER_FIELD, GW_SWITCH_FIELD)
    GW_EFFECTS_SETTINGS(GW_NUMBER_FIELD, GW_SWITCH_FIELD)
    GW_PAD_SETTINGS(GW_NUMBER_FIELD, GW_SWITCH_FIELD)
    GW_VIDEO_SETTINGS(GW_NUMBER_FIELD, GW_SWITCH_FIELD)
    // clang-format on
};

}  // namespace

std::span<const SettingsField> settingsFields() {
  return kFields;
}

}  // namespace gw
