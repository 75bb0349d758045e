// The replay's reader, with the bytes as they come and with checksums that fit them. What it takes, the writer writes
// again, and that is read as the same. What is whole of a file that was cut is read too.
#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/sealed_replay.h"

namespace gw::fuzz {
namespace {

void readPartial(std::span<const uint8_t> bytes) {
  try {
    const Replay replay = decodeReplay(bytes, "fuzz.gwr", SimulationVersions::any, Completeness::partial);
    demand(replay.ticks() > 0 && replay.hashes.size() == replay.inputs.size(), "a part of a replay has no ticks");
  } catch (const ReplayError& error) {
    demandSentence(error.what());
  }
}

void read(std::span<const uint8_t> bytes) {
  readPartial(bytes);
  Replay replay;
  try {
    replay = decodeReplay(bytes, "fuzz.gwr", SimulationVersions::any);
  } catch (const ReplayError& error) {
    demandSentence(error.what());
    return;
  }
  const Replay again = decodeReplay(encodeReplay(replay), "fuzz.gwr", SimulationVersions::any);
  demand(again.header == replay.header && again.rules == replay.rules && again.inputs == replay.inputs &&
             again.hashes == replay.hashes && again.fieldHashes == replay.fieldHashes && again.result == replay.result,
         "a replay is another one once it has been written and read");
}

}  // namespace
}  // namespace gw::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  gw::fuzz::read({data, size});
  gw::fuzz::read(gw::fuzz::sealed({data, size}));
  return 0;
}
