// gpuwars trim FILE --out OUT: run a replay again up to a tick, and write what was run as a whole replay of today's
// format.
#include <algorithm>
#include <cstdio>

#include "game/cli/trim_options.h"
#include "game/commands/progress.h"
#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "game/session/device_choice.h"
#include "host/platform/interrupt.h"
#include "host/platform/number_format.h"
#include "host/platform/part_file.h"
#include "host/platform/user_error.h"

namespace gw {
namespace {

uint32_t ticksToRun(const Replay& replay, const TrimOptions& options) {
  if (options.toTick <= replay.ticks()) return options.toTick == 0 ? replay.ticks() : options.toTick;
  throw UserError(ExitCode::badUsage, "'--to " + std::to_string(options.toTick) + "' is past the end of " +
                                          options.file.string() + "; give a tick up to " +
                                          std::to_string(replay.ticks()) + ", or leave it out.");
}

[[noreturn]] void refuseDifference(const TrimOptions& options, uint32_t tick, uint64_t recorded, uint64_t computed) {
  const std::string shorter = tick == 1 ? "" : "trim it with '--to " + std::to_string(tick - 1) + "', or ";
  throw UserError(ExitCode::desync, options.file.string() + " differs from tick " + std::to_string(tick) +
                                        " on (recorded " + hexadecimal(recorded) + ", computed " +
                                        hexadecimal(computed) + "), and nothing was written; " + shorter +
                                        "use the build that recorded it.");
}

// The same run, made of what was computed. Ends where the game is over.
Replay runAgain(const Replay& recorded, uint32_t ticks, Simulation& simulation, const TrimOptions& options) {
  Replay made;
  made.header = recorded.header;
  made.rules = recorded.rules;
  Progress progress("tick", ticks);
  uint32_t queued = 0;
  bool over = false;
  while (made.ticks() < ticks && !over && !interrupted()) {
    while (queued < ticks && queued - made.ticks() < Simulation::kTicksInFlight) {
      simulation.tick(recorded.inputs[queued++]);
    }
    const TickReport report = simulation.report();
    const uint32_t tick = made.ticks();
    if (report.hash != recorded.hashes[tick]) {
      refuseDifference(options, tick + 1, recorded.hashes[tick], report.hash);
    }
    made.inputs.push_back(recorded.inputs[tick]);
    made.hashes.push_back(report.hash);
    if (made.ticks() % kFieldHashesEvery_ticks == 0) {
      std::copy(std::begin(report.fieldHashes), std::end(report.fieldHashes), made.fieldHashes.emplace_back().begin());
    }
    over = report.over != 0;
    made.result = {report.score, report.kills, report.frameTime_us, over};
    progress.show(made.ticks());
  }
  if (made.ticks() < ticks && !over) {
    throw UserError(ExitCode::failedRun, "Interrupted after " + withCommas(made.ticks()) + " of " + withCommas(ticks) +
                                             " ticks, and nothing was written; run it again to its end.");
  }
  return made;
}

}  // namespace

ExitCode runVerb(const TrimOptions& options) {
  catchInterrupts();
  const std::filesystem::path& file = options.file;
  const Replay recorded = readReplay(file, SimulationVersions::current, Completeness::partial);
  const uint32_t ticks = ticksToRun(recorded, options);
  checkWritable(options.outPath);
  std::error_code unequal;
  if (std::filesystem::equivalent(file, options.outPath, unequal) && isBeingWritten(file)) {
    throw UserError(ExitCode::badFile, file.string() +
                                           " is still being recorded by a running game, which removes it at the "
                                           "end; give '--out' another name.");
  }
  SimulationConfig config = replayConfig(recorded);
  setComputingOf(config, options, file.string());
  const std::unique_ptr<Simulation> simulation = makeSimulation(chooseDevice(options.device), config);
  const Replay made = runAgain(recorded, ticks, *simulation, options);
  writeReplay(options.outPath, made);
  std::printf("%s: %s of %s ticks%s, score %s, %s\n", options.outPath.c_str(), withCommas(made.ticks()).c_str(),
              withCommas(recorded.ticks()).c_str(), recorded.whole ? "" : " (it had no end)",
              withCommas(made.result.score).c_str(), made.result.over ? "over" : "not over");
  return ExitCode::fine;
}

}  // namespace gw
