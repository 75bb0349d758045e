// replay_inputs FILE
// Writes each tick's recorded input: move_x move_y aim buttons.
#include <cstdio>
#include <exception>

#include "game/replay/replay_reader.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    for (const gw::InputRecord& input : gw::readReplay(argv[1]).inputs) {
      std::printf("%d %d %u %u\n", input.move_x, input.move_y, unsigned(input.aim), unsigned(input.buttons));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
