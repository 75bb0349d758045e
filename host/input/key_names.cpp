#include "host/input/key_names.h"

#include <array>

namespace gw {

namespace {

using Names = std::array<std::string_view, kKeys>;

constexpr void name(Names& names, size_t first, std::initializer_list<std::string_view> list) {
  for (const std::string_view text : list) names[first++] = text;
}

// By code. 158 would be a second "Return".
constexpr Names kNames = [] {
  Names names{};
  name(names, 4, {"A",        "B",           "C",          "D",         "E",
                  "F",        "G",           "H",          "I",         "J",
                  "K",        "L",           "M",          "N",         "O",
                  "P",        "Q",           "R",          "S",         "T",
                  "U",        "V",           "W",          "X",         "Y",
                  "Z",        "1",           "2",          "3",         "4",
                  "5",        "6",           "7",          "8",         "9",
                  "0",        "Return",      "Escape",     "Backspace", "Tab",
                  "Space",    "-",           "=",          "[",         "]",
                  "\\",       "#",           ";",          "'",         "`",
                  ",",        ".",           "/",          "CapsLock",  "F1",
                  "F2",       "F3",          "F4",         "F5",        "F6",
                  "F7",       "F8",          "F9",         "F10",       "F11",
                  "F12",      "PrintScreen", "ScrollLock", "Pause",     "Insert",
                  "Home",     "PageUp",      "Delete",     "End",       "PageDown",
                  "Right",    "Left",        "Down",       "Up",        "Numlock",
                  "Keypad /", "Keypad *",    "Keypad -",   "Keypad +",  "Keypad Enter",
                  "Keypad 1", "Keypad 2",    "Keypad 3",   "Keypad 4",  "Keypad 5",
                  "Keypad 6", "Keypad 7",    "Keypad 8",   "Keypad 9",  "Keypad 0",
                  "Keypad ."});
  name(names, 101,
       {"Application", "Power", "Keypad =", "F13",  "F14",   "F15",     "F16",  "F17",      "F18",       "F19",
        "F20",         "F21",   "F22",      "F23",  "F24",   "Execute", "Help", "Menu",     "Select",    "Stop",
        "Again",       "Undo",  "Cut",      "Copy", "Paste", "Find",    "Mute", "VolumeUp", "VolumeDown"});
  name(names, 133, {"Keypad ,", "Keypad = (AS400)"});
  name(names, 153, {"AltErase", "SysReq", "Cancel", "Clear", "Prior"});
  name(names, 159, {"Separator", "Out", "Oper", "Clear / Again", "CrSel", "ExSel"});
  name(names, 176,
       {"Keypad 00",         "Keypad 000",         "ThousandsSeparator", "DecimalSeparator", "CurrencyUnit",
        "CurrencySubUnit",   "Keypad (",           "Keypad )",           "Keypad {",         "Keypad }",
        "Keypad Tab",        "Keypad Backspace",   "Keypad A",           "Keypad B",         "Keypad C",
        "Keypad D",          "Keypad E",           "Keypad F",           "Keypad XOR",       "Keypad ^",
        "Keypad %",          "Keypad <",           "Keypad >",           "Keypad &",         "Keypad &&",
        "Keypad |",          "Keypad ||",          "Keypad :",           "Keypad #",         "Keypad Space",
        "Keypad @",          "Keypad !",           "Keypad MemStore",    "Keypad MemRecall", "Keypad MemClear",
        "Keypad MemAdd",     "Keypad MemSubtract", "Keypad MemMultiply", "Keypad MemDivide", "Keypad +/-",
        "Keypad Clear",      "Keypad ClearEntry",  "Keypad Binary",      "Keypad Octal",     "Keypad Decimal",
        "Keypad Hexadecimal"});
  name(names, 224,
       {"Left Ctrl", "Left Shift", "Left Alt", "Left GUI", "Right Ctrl", "Right Shift", "Right Alt", "Right GUI"});
  name(names, 257,
       {"ModeSwitch",     "AudioNext",    "AudioPrev",     "AudioStop",      "AudioPlay",    "AudioMute",
        "MediaSelect",    "WWW",          "Mail",          "Calculator",     "Computer",     "AC Search",
        "AC Home",        "AC Back",      "AC Forward",    "AC Stop",        "AC Refresh",   "AC Bookmarks",
        "BrightnessDown", "BrightnessUp", "DisplaySwitch", "KBDIllumToggle", "KBDIllumDown", "KBDIllumUp",
        "Eject",          "Sleep",        "App1",          "App2",           "AudioRewind",  "AudioFastForward",
        "SoftLeft",       "SoftRight",    "Call",          "EndCall"});
  return names;
}();

// Later versions of SDL have names for these, too.
constexpr uint16_t kNonUsBackslash = 100, kInternational = 135, kLanguage = 144;  // nine each of the latter

}  // namespace

std::string_view keyName(uint16_t code) {
  return code < kNames.size() ? kNames[code] : std::string_view();
}

std::string laterKeyName(uint16_t code) {
  const auto numbered = [&](const char* text, uint16_t first) { return text + std::to_string(code - first + 1); };
  if (code == kNonUsBackslash) return "NonUSBackslash";
  if (code >= kInternational && code < kInternational + 9) return numbered("International ", kInternational);
  if (code >= kLanguage && code < kLanguage + 9) return numbered("Language ", kLanguage);
  return "";
}

}  // namespace gw
