// record_scene OUT.gwr ASSETS [TICKS]: records the five minutes of 'gpuwars profile' again, on the cpu device, after a
// change that is meant to change the game.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "game/profile/session/scene.h"
#include "game/replay/replay_writer.h"

namespace {

void record(const char* out, const char* assets, uint32_t ticks) {
  using namespace gw;
  const auto make = [](const SimulationConfig& config) { return cpu::makeSimulation(config); };
  const auto show = [&](uint32_t tick) {
    if (tick % 600 == 0) std::fprintf(stderr, "tick %u\n", tick);
    return true;
  };
  const profile::Scene scene =
      profile::recordScene(profile::SceneKind::fiveMinutes, {8192, ticks}, readRuleTexts(assets), make, show);
  writeReplay(out, scene.replay);
  std::printf("%s: %u ticks, score %llu, %llu kills\n", out, scene.replay.ticks(),
              static_cast<unsigned long long>(scene.replay.result.score),
              static_cast<unsigned long long>(scene.replay.result.kills));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: record_scene OUT.gwr ASSETS [TICKS]\n");
    return 2;
  }
  try {
    record(argv[1], argv[2], argc > 3 ? uint32_t(std::strtoul(argv[3], nullptr, 10)) : 0);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
