// A WAV file of assets/sounds.
#include <stdexcept>

#include "game/audio/sound_bank.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace gw;
  try {
    const Clip clip = parseWav({data, data + size});
    fuzz::demand(!clip.samples.empty(), "a sound without samples was taken");
    for (const float peak : peaksFrom(clip)) fuzz::demand(peak >= 0 && peak <= 1, "a peak lies outside 0 to 1");
  } catch (const std::runtime_error& error) {
    fuzz::demandSentence(error.what());
  }
  return 0;
}
