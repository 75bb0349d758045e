// Changes a replay by its parts, so that most of what libFuzzer tries can be read: the header's numbers, an input, a
// number or any text of a table. Linked to fuzzers only.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <random>
#include <stdexcept>
#include <string_view>

#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "tests/fuzz/sealed_replay.h"

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t maxSize);

namespace gw::fuzz {
namespace {

using Chance = std::minstd_rand;

uint32_t below(Chance& chance, size_t count) {
  return uint32_t(chance() % count);
}

void mutateInputs(Replay& replay, Chance& chance) {
  constexpr size_t kMost = 64;  // so many are played
  replay.inputs.resize(std::clamp<size_t>(replay.inputs.size(), 1, kMost));
  for (uint32_t n = 1 + below(chance, 4); n > 0; --n) {
    InputRecord input;
    input.move_x = int16_t(int(below(chance, 2 * kStickFull + 1)) - kStickFull);
    input.move_y = int16_t(int(below(chance, 2 * kStickFull + 1)) - kStickFull);
    input.aim = uint16_t(chance());
    input.buttons = uint16_t(chance() & kButtonsKnown);
    const size_t first = below(chance, replay.inputs.size()), last = first + 1 + below(chance, 16);
    std::fill(replay.inputs.begin() + ptrdiff_t(first),
              replay.inputs.begin() + ptrdiff_t(std::min(last, replay.inputs.size())), input);
  }
  replay.hashes.resize(replay.inputs.size());
  replay.fieldHashes.clear();
}

void mutateHeader(Replay& replay, Chance& chance) {
  ReplayHeader& header = replay.header;
  switch (below(chance, 4)) {
    case 0:
      header.seed = uint64_t(chance()) << 32 ^ chance();
      break;
    case 1:
      header.mode = Mode(below(chance, uint32_t(Mode::practice) + 1));
      break;
    case 2:
      header.enemies = 1 + below(chance, 300);
      break;
    default:
      header.gather = Gather(below(chance, uint32_t(Gather::fixed) + 1));
      header.sort = header.gather == Gather::exact ? Sort::bitonic : Sort(below(chance, 2));
  }
}

// Numbers where rules change, beside small ones.
void mutateNumber(std::string& text, Chance& chance) {
  static constexpr std::array<std::string_view, 20> kNumbers = {
      "0",     "1",       "2",          "3",   "10",    "16",   "64",  "100", "255",   "1000",
      "65535", "1000000", "4294967295", "0.0", "0.001", "0.01", "0.5", "1.0", "100.0", "1000.0"};
  std::vector<size_t> begins;
  for (size_t i = 1; i < text.size(); ++i) {
    const auto digit = [&](size_t at) { return std::isdigit(uint8_t(text[at])) || text[at] == '.'; };
    if (digit(i) && !digit(i - 1) && !std::isalpha(uint8_t(text[i - 1]))) begins.push_back(i);
  }
  if (begins.empty()) return;
  const size_t begin = begins[below(chance, begins.size())];
  size_t end = begin;
  while (end < text.size() && (std::isdigit(uint8_t(text[end])) || text[end] == '.')) ++end;
  text.replace(begin, end - begin, kNumbers[below(chance, kNumbers.size())]);
}

void mutateText(std::string& text, Chance& chance) {
  if (below(chance, 8) > 0) return mutateNumber(text, chance);
  const size_t size = text.size(), most = std::min(size + 256, kMaxRuleText);
  text.resize(most);
  text.resize(LLVMFuzzerMutate(reinterpret_cast<uint8_t*>(text.data()), size, most));
}

void mutate(Replay& replay, Chance& chance) {
  RuleText* texts[] = {&replay.rules.game, &replay.rules.enemies, &replay.rules.waves};
  for (uint32_t n = 1 + below(chance, 3); n > 0; --n) {
    switch (below(chance, 4)) {
      case 0:
        mutateHeader(replay, chance);
        break;
      case 1:
        mutateInputs(replay, chance);
        break;
      default:
        mutateText(texts[below(chance, 3)]->text, chance);
    }
  }
}

}  // namespace
}  // namespace gw::fuzz

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t maxSize, unsigned int seed) {
  using namespace gw;
  fuzz::Chance chance(seed + 1);
  try {
    Replay replay = decodeReplay(fuzz::sealed({data, size}), "fuzz.gwr", SimulationVersions::any);
    fuzz::mutate(replay, chance);
    const std::vector<uint8_t> bytes = encodeReplay(replay);
    if (bytes.size() <= maxSize && fuzz::below(chance, 16) > 0) {
      std::memcpy(data, bytes.data(), bytes.size());
      return bytes.size();
    }
  } catch (const std::exception&) {  // no replay, or none that a file can hold: its bytes are changed instead
  }
  return LLVMFuzzerMutate(data, size, maxSize);
}
