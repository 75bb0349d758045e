// gpuwars play: in a window, or headless: ticks as fast as possible, and a summary.
#include <cstdio>

#include "game/cli/play_options.h"
#include "game/commands/hash_file.h"
#include "game/commands/progress.h"
#include "game/commands/window.h"
#include "game/session/run_factory.h"
#include "game/ui/hud.h"
#include "game/ui/mode_choice.h"
#include "game/ui/tick_text.h"
#include "game/view/follow_camera.h"
#include "game/view/offscreen_renderer.h"
#include "gpu/exec/kernel_count.h"
#include "host/platform/atomic_file.h"
#include "host/platform/clock.h"
#include "host/platform/interrupt.h"
#include "host/platform/number_format.h"
#include "host/video/picture_file.h"

namespace gw {

namespace {

constexpr uint32_t kSampleEvery_ticks = 60;  // of the candidates: a search of its own, not timed

struct Measured {
  double seconds = 0;  // ticks only
  CandidateCount candidates;
  uint32_t samples = 0;
};

// Ticks until the end, the limit or Ctrl-C. The queue is kept full between samples, so that a device
// which can run ahead does.
Measured runTicks(Run& run, const PlayOptions& options, HashFile& hashes) {
  Measured measured;
  Progress progress("tick", options.ticks);
  uint32_t queued = 0;
  while (!run.over() && run.last().tick < options.ticks && !interrupted()) {
    const uint32_t stop = std::min(options.ticks, (run.last().tick / kSampleEvery_ticks + 1) * kSampleEvery_ticks);
    const double start_s = now_s();
    while (run.last().tick < stop && !run.over()) {
      while (queued < stop && run.queued() < Simulation::kTicksInFlight) {
        run.queue({});
        ++queued;
      }
      if (run.collect()) hashes.write(run.last().tick, run.last().hash);
    }
    while (run.queued() > 0) run.collect();
    measured.seconds += now_s() - start_s;
    if (!run.over()) {
      const CandidateCount count = run.simulation().countCandidates();
      measured.candidates.tested += count.tested;
      measured.candidates.entities += count.entities;
      ++measured.samples;
    }
    progress.show(run.last().tick);
  }
  return measured;
}

std::string endingText(const TickReport& report, const Rules& rules) {
  switch (report.ending) {
    case Ending::frameRate:
      return "under " + oneDecimal(framesPerSecond(rules.budget.limit_us)) + " FPS";
    case Ending::timeUp:
      return "time up";
    case Ending::cleared:
      return "cleared";
    case Ending::none:
      break;
  }
  return "not over";
}

void printSummary(Run& run, const RunFactory& factory, const PlayOptions& options, uint64_t seed,
                  const Measured& measured) {
  const TickReport& report = run.last();
  const Rules& rules = factory.rules();
  const auto line = [](const char* name, const std::string& value) { std::printf("%-12s %s\n", name, value.c_str()); };
  line("device",
       run.simulation().deviceName() + (factory.device().why.empty() ? "" : "  (" + factory.device().why + ")"));
  line("game", "seed " + std::to_string(seed) + ", " + withCommas(options.enemies) + " enemies fit, " +
                   withCommas(run.simulation().capacity()) + " entities");
  line("mode", std::string(modeName(options.mode)) + ": " + endingText(report, rules));
  const std::string neighbours = neighboursText(options.gather.value_or(Gather::exact), options.sort);
  if (!neighbours.empty()) line("neighbours", neighbours + "; misses some, see docs/results/thesis-preset.md");
  line("ticks", withCommas(report.tick) + (report.over     ? " (over at tick " + std::to_string(report.tick) + ")"
                                           : interrupted() ? " (interrupted)"
                                                           : ""));
  line("ticks/s", measured.seconds > 0 ? oneDecimal(report.tick / measured.seconds) : "-");
  line("survived", minutesSeconds(report.tick));
  line("score", withCommas(report.score));
  line("multiplier", multiplierText(report.multiplierTenths));
  line("budget",
       oneDecimal(report.frameTime_us / 1000.0) + " ms, " + oneDecimal(framesPerSecond(report.frameTime_us)) + " FPS");
  std::string kills = withCommas(report.kills);
  for (uint32_t i = 0; i < rules.enemyTypeCount; ++i) {
    kills += (i == 0 ? ": " : ", ") + std::string(rules.enemies[i].name) + " " + withCommas(report.killsByType[i]);
  }
  line("kills", kills);
  line("peak alive", withCommas(report.peakEnemies));
  line("contacts", withCommas(report.contacts));
  line("bits taken", withCommas(report.bitsTaken));
  line("refused", withCommas(report.refused) + " births");
  line("candidates", measured.candidates.entities == 0
                         ? std::string("-")
                         : oneDecimal(double(measured.candidates.tested) / double(measured.candidates.entities)) +
                               " per enemy, " + std::to_string(measured.samples) + " samples");
  line("state hash", hexadecimal(report.hash));
  if (run.recorded()) line("recorded", factory.recordPath().string());
}

void takePicture(Run& run, const RunFactory& factory, const PlayOptions& options) {
  OffscreenRenderer maker({int(options.width_px), int(options.height_px)}, factory.assets(), run.simulation());
  FollowCamera camera(run.simulation().worldWidth_m(), run.simulation().worldHeight_m());
  camera.snap(cameraTarget(run.last(), 1), maker.aspect());
  const Image image = maker.draw(run, factory.rules(), camera, 1, [&](Canvas& canvas) {
    HudFrame hud;
    hud.realFps = 0;
    hud.mode = options.mode;
    hud.enemies = options.enemies;
    drawHud(canvas, run.monitor(), factory.rules(), hud);
  });
  writePicture(options.screenshotPath, image);
}

ExitCode playHeadless(const PlayOptions& options) {
  catchInterrupts();
  const uint64_t seed = options.seed.value_or(1);
  RunFactory factory(options);
  HashFile hashes(options.hashesPath);
  if (!options.screenshotPath.empty()) checkWritable(options.screenshotPath);
  std::unique_ptr<Run> run = factory.make(options.mode, seed, options.autopilot, true);
  const Measured measured = runTicks(*run, options, hashes);
  run->finishRecording();
  const bool quiet = hashes.isStdout();  // then stdout is data
  hashes.close();
  if (!options.screenshotPath.empty()) takePicture(*run, factory, options);
  if (!quiet) printSummary(*run, factory, options, seed, measured);
  run.reset();  // waits for the device, so that all its kernels are counted
  if (!quiet && factory.device().cuda) std::printf("%s CUDA kernels run\n", withCommas(cudaKernelsRun).c_str());
  return ExitCode::fine;
}

}  // namespace

ExitCode runVerb(const PlayOptions& options) {
  return options.headless ? playHeadless(options) : playWindow(options);
}

}  // namespace gw
