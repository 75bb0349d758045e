// The settings file. Whatever it holds, there are settings; what is written of them is read as the same, without
// complaint; and what is changed in the text leaves all else as it was.
#include "game/settings/settings_edit.h"
#include "game/settings/settings_text.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace gw;
  const ReadSettings first = readSettings(fuzz::textOf(data, size), "settings.toml");
  for (const std::string& complaint : first.complaints) fuzz::demandSentence(complaint);
  const ReadSettings again = readSettings(writeSettings(first.settings, first.unknown), "settings.toml");
  fuzz::demand(again.settings == first.settings, "settings are others once they have been written and read");
  fuzz::demand(!again.damaged, "what was written is damaged");
  fuzz::demand(again.unknown == first.unknown, "keys of another version are lost by writing");

  Settings changed = first.settings;
  changed.sound.muted = !changed.sound.muted;
  changed.pad.aimDeadZone = 0.7f;
  changed.bindings.codes(InputDevice::keyboard, Action::fire) = {10, 20};
  const std::string text = fuzz::textOf(data, size);
  if (const auto edited = editSettings(text, first, changed)) {
    const ReadSettings third = readSettings(*edited, "settings.toml");
    fuzz::demand(third.settings == changed && !third.damaged, "what was changed in the text is not read from it");
    fuzz::demand(third.unknown == first.unknown, "keys of another version are lost by a change");
  }
  return 0;
}
