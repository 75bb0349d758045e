// How long going to a tick of a replay takes, as a viewer waits for it:
//
//   gw_bench_replay_seeks FILE [SEEKS]     random ticks (40), after the prefetch thread has finished; seconds on stdout
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>

#include "game/replay/replay_reader.h"
#include "game/replay_viewer/replay_viewer.h"
#include "host/platform/clock.h"

using namespace gw;

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "There is no replay to measure: gw_bench_replay_seeks FILE [SEEKS].\n");
    return 2;
  }
  const int seeks = argc > 2 ? std::max(1, std::atoi(argv[2])) : 40;
  try {
    const Replay replay = readReplay(argv[1]);
    SimulationConfig config = replayConfig(replay);
    config.particles = true;
    SimulationConfig prefetch = config;
    prefetch.threads = 1;
    prefetch.particles = false;
    const double begun_s = now_s();
    ReplayViewer viewer(replay, cpu::makeSimulation(config), [&] { return cpu::makeSimulation(prefetch); });
    while (!viewer.prefetched()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::printf("%s: %u ticks, prefetched in %.1f s, %zu snapshots of %.1f MiB\n", argv[1], replay.ticks(),
                now_s() - begun_s, viewer.cache().count(), double(viewer.cache().bytes()) / (1 << 20));
    std::mt19937 dice(1);
    std::vector<double> took_s, back_s, work_s;
    uint32_t worstTick = 0;
    const auto go = [&](uint32_t tick) {
      const double start_s = now_s();
      viewer.seek(tick);
      while (!viewer.continueSeek(1000)) {
      }
      return now_s() - start_s;
    };
    for (int i = 0; i < seeks; ++i) {
      const uint32_t tick = 1 + dice() % replay.ticks();
      const double before_s = processTime_s();
      took_s.push_back(go(tick));
      work_s.push_back(processTime_s() - before_s);
      if (took_s.back() >= *std::max_element(took_s.begin(), took_s.end())) worstTick = tick;
      back_s.push_back(go(tick - 1));
    }
    std::sort(took_s.begin(), took_s.end());
    std::sort(work_s.begin(), work_s.end());
    std::sort(back_s.begin(), back_s.end());
    std::printf("%d random seeks: median %.3f s, worst %.3f s (tick %u)\n", seeks, took_s[took_s.size() / 2],
                took_s.back(), worstTick);
    std::printf("  processor time of all threads: median %.3f s, worst %.3f s\n", work_s[work_s.size() / 2],
                work_s.back());
    std::printf("%d single ticks back: median %.3f s, worst %.3f s\n", seeks, back_s[back_s.size() / 2], back_s.back());
    return viewer.differsFrom() ? 4 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
