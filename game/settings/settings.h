// The choices of the player beyond the command line, stored in one TOML file (settings_file.h). Every value has a
// default, so that a missing or damaged entry affects only itself.
#pragma once

#include "host/input/bindings.h"

namespace gw {

// Every plain setting, by section of the file. One row adds a setting: its member below, its key in the file and its
// row on the settings screen, in this order.
//   NUMBER(section, member, "key in the file", default, most, "label on the screen")      from 0 to most
//   SWITCH(section, member, "key in the file", default, "label on the screen")
#define GW_SOUND_SETTINGS(NUMBER, SWITCH)                     \
  NUMBER(sound, effects, "effects", 0.8f, 1, "sound effects") \
  NUMBER(sound, music, "music", 0.6f, 1, "music")             \
  SWITCH(sound, muted, "muted", false, "mute all")

// Drawing only; off means not at all. Shake and flash scale every shake and every sudden brightness of the whole
// picture. Glow is how far light reaches outside a shape, and the most expensive effect where no GPU draws.
#define GW_EFFECTS_SETTINGS(NUMBER, SWITCH)                          \
  NUMBER(effects, shake, "shake", 1, 1, "screen shake")              \
  NUMBER(effects, flash, "flash", 1, 1, "flashes")                   \
  NUMBER(effects, glow, "glow", 0.5f, 1, "glow")                     \
  SWITCH(effects, particles, "particles", true, "particles")         \
  SWITCH(effects, gridBending, "grid_bending", true, "grid bending") \
  SWITCH(effects, scorePops, "score_pops", true, "score pops")

// Shares of full deflection. A stick could not be used with a dead zone of 1.
#define GW_PAD_SETTINGS(NUMBER, SWITCH)                                            \
  NUMBER(pad, moveDeadZone, "move_dead_zone", 0.2f, 0.9f, "dead zone, move stick") \
  NUMBER(pad, aimDeadZone, "aim_dead_zone", 0.25f, 0.9f, "dead zone, aim stick")

#define GW_VIDEO_SETTINGS(NUMBER, SWITCH)                      \
  SWITCH(video, fullscreen, "fullscreen", false, "fullscreen") \
  SWITCH(video, keepPointer, "keep_pointer", true, "keep the pointer in play")

struct Settings {
#define GW_NUMBER_MEMBER(section, member, key, initial, most, label) float member = initial;
#define GW_SWITCH_MEMBER(section, member, key, initial, label) bool member = initial;
  struct Sound {
    GW_SOUND_SETTINGS(GW_NUMBER_MEMBER, GW_SWITCH_MEMBER)
    friend bool operator==(const Sound&, const Sound&) = default;
  } sound;
  struct Effects {
    GW_EFFECTS_SETTINGS(GW_NUMBER_MEMBER, GW_SWITCH_MEMBER)
    friend bool operator==(const Effects&, const Effects&) = default;
  } effects;
  struct Pad {
    GW_PAD_SETTINGS(GW_NUMBER_MEMBER, GW_SWITCH_MEMBER)
    friend bool operator==(const Pad&, const Pad&) = default;
  } pad;
  struct Video {
    GW_VIDEO_SETTINGS(GW_NUMBER_MEMBER, GW_SWITCH_MEMBER)
    friend bool operator==(const Video&, const Video&) = default;
  } video;
#undef GW_NUMBER_MEMBER
#undef GW_SWITCH_MEMBER
  Bindings bindings;

  friend bool operator==(const Settings&, const Settings&) = default;
};

}  // namespace gw
