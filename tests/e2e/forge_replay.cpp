// forge_replay IN OUT hash TICK | input TICK | score | longer
// Writes a replay that is whole and yet wrong in one place, for tests of the checker. Longer: 30 ticks more, in which
// nothing happens.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  try {
    gw::Replay replay = gw::readReplay(argv[1]);
    const std::string what = argv[3];
    const size_t tick = argc > 4 ? std::strtoul(argv[4], nullptr, 10) : 1;
    if (tick < 1 || tick > replay.ticks()) return 2;
    if (what == "hash") replay.hashes[tick - 1] ^= 1;
    if (what == "input") replay.inputs[tick - 1].move_x = int16_t(replay.inputs[tick - 1].move_x > 0 ? -32767 : 32767);
    if (what == "score") ++replay.result.score;
    if (what == "longer") {
      replay.inputs.resize(replay.inputs.size() + 30);
      replay.hashes.resize(replay.hashes.size() + 30, replay.hashes.back());
      replay.fieldHashes.clear();  // those of the added ticks are not known here
    }
    gw::writeReplay(argv[2], replay);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
