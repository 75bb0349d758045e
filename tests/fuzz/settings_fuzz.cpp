// The settings file. Whatever it holds, there are settings; and what is written of them is read as the same, without
// complaint.
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
  return 0;
}
