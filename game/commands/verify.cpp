// gpuwars verify FILE...: run replays again and compare every tick. Several files at a time with -j.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <vector>

#include "game/commands/commands.h"
#include "game/commands/hash_file.h"
#include "game/commands/json_output.h"
#include "game/commands/progress.h"
#include "game/commands/run_facts.h"
#include "game/device_choice.h"
#include "game/interrupt.h"
#include "game/replay/replay_reader.h"
#include "game/ui/format.h"
#include "game/user_error.h"
#include "gpu/kernel_count.h"

namespace gw {

namespace {

struct Difference {
  uint32_t tick = 0;
  uint64_t recorded = 0, actual = 0;
};

struct Outcome {
  std::string file, error, device;
  ExitCode code = ExitCode::failedRun;
  uint32_t ticks = 0, compared = 0;
  double seconds = 0;
  std::optional<Difference> first;
  std::string wrongResult;       // every tick equal, and yet the recorded result is another
  std::vector<uint64_t> hashes;  // as computed
  RunFacts facts;
  SimulationConfig config;  // the replay's own
};

void compare(Outcome& outcome, const Replay& replay, Simulation& simulation) {
  outcome.ticks = replay.ticks();
  outcome.device = simulation.deviceName();
  const auto start = std::chrono::steady_clock::now();
  uint32_t queued = 0;
  while (outcome.compared < replay.ticks() && !interrupted()) {
    while (queued < replay.ticks() && queued - outcome.compared < Simulation::kTicksInFlight) {
      simulation.tick(replay.inputs[queued++]);
    }
    const TickReport report = simulation.report();
    const uint32_t tick = outcome.compared++;
    outcome.hashes.push_back(report.hash);
    if (report.hash != replay.hashes[tick] && !outcome.first) {
      outcome.first = Difference{tick + 1, replay.hashes[tick], report.hash};
    }
    outcome.facts.add(report);
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void judge(Outcome& outcome, const Replay& replay) {
  const TickReport& last = outcome.facts.last;
  if (outcome.compared < replay.ticks()) {
    outcome.error = "interrupted after " + std::to_string(outcome.compared) + " of " + std::to_string(replay.ticks()) +
                    " ticks; run it again to its end";
    outcome.code = ExitCode::failedRun;
  } else if (outcome.first) {
    outcome.code = ExitCode::desync;
  } else if (replay.result != FinalReport{last.score, last.kills, last.frameTime_us, last.over != 0}) {
    outcome.wrongResult = "the recorded result is score " + std::to_string(replay.result.score) + ", computed " +
                          std::to_string(last.score);
    outcome.code = ExitCode::desync;
  } else {
    outcome.code = ExitCode::fine;
  }
}

Outcome verifyOne(const std::filesystem::path& file, const Options& options, const DeviceChoice& device) {
  Outcome outcome;
  outcome.file = file.string();
  try {
    const Replay replay = readReplay(file);
    SimulationConfig config = replayConfig(replay);
    outcome.config = config;
    setComputingOf(config, options, outcome.file);
    if (config.threads == 0 && options.jobs > 1) {  // the machine is shared between the jobs
      config.threads = std::max(1u, std::thread::hardware_concurrency() / options.jobs);
    }
    const std::unique_ptr<Simulation> simulation = makeSimulation(device, config);
    compare(outcome, replay, *simulation);
    judge(outcome, replay);
  } catch (const ReplayError& error) {
    outcome.error = error.what();
    outcome.code = ExitCode::badFile;
  } catch (const TableError& error) {
    outcome.error = error.what();
    outcome.code = ExitCode::badFile;
  } catch (const UserError& error) {
    outcome.error = error.what();
    outcome.code = error.code;
  } catch (const std::bad_alloc&) {
    outcome.error = outcome.file + " needs more memory than there is: verify it on a larger machine.";
  } catch (const std::exception& error) {
    outcome.error = error.what();
  }
  return outcome;
}

nlohmann::ordered_json toJson(const Outcome& outcome) {
  nlohmann::ordered_json json;
  json["file"] = outcome.file;
  json["equal"] = outcome.code == ExitCode::fine;
  json["exitCode"] = int(outcome.code);
  json["device"] = outcome.device;
  json["ticks"] = outcome.ticks;
  json["ticksCompared"] = outcome.compared;
  json["ticksPerSecond"] = outcome.seconds > 0 ? outcome.compared / outcome.seconds : 0;
  if (outcome.first) {
    json["firstDifference"] = {{"tick", outcome.first->tick},
                               {"recorded", hexadecimal(outcome.first->recorded)},
                               {"computed", hexadecimal(outcome.first->actual)}};
  }
  if (!outcome.wrongResult.empty()) json["wrongResult"] = outcome.wrongResult;
  if (!outcome.error.empty()) json["error"] = outcome.error;
  factsToJson(json, outcome.facts, outcome.config);
  return json;
}

// Results on stdout; what failed in one sentence on stderr.
void say(const Outcome& outcome, bool quiet) {
  const std::string ticks = withCommas(outcome.compared) + " of " + withCommas(outcome.ticks) + " ticks compared";
  const std::string speed =
      oneDecimal(outcome.seconds > 0 ? outcome.compared / outcome.seconds : 0) + " ticks/s, " + outcome.device;
  const char* name = outcome.file.c_str();
  if (outcome.code == ExitCode::fine) {
    if (!quiet) std::printf("equal    %s: %s, %s\n", name, ticks.c_str(), speed.c_str());
  } else if (outcome.first) {
    if (!quiet) std::printf("DESYNC   %s: %s, %s\n", name, ticks.c_str(), speed.c_str());
    std::fprintf(stderr,
                 "%s: tick %u is the first that differs: recorded %s, computed %s; "
                 "see docs/determinism.md for how to find the cause.\n",
                 name, outcome.first->tick, hexadecimal(outcome.first->recorded).c_str(),
                 hexadecimal(outcome.first->actual).c_str());
  } else if (!outcome.wrongResult.empty()) {
    std::fprintf(stderr, "%s: every tick is equal, but %s; record it again.\n", name, outcome.wrongResult.c_str());
  } else {
    std::fprintf(stderr, "%s\n", outcome.error.c_str());
  }
}

// The worst: a desync before a bad file before a run that failed.
ExitCode worst(const std::vector<Outcome>& outcomes) {
  ExitCode code = ExitCode::fine;
  for (const Outcome& outcome : outcomes) code = std::max(code, outcome.code);
  return code;
}

}  // namespace

ExitCode verifyReplays(const Options& options) {
  catchInterrupts();
  const DeviceChoice device = chooseDevice(options.device);
  HashFile hashes(options.hashesPath);
  const bool quiet = hashes.isStdout() || options.jsonPath == "-";
  if (!quiet && !device.why.empty()) std::printf("%s\n", device.why.c_str());

  const size_t count = options.files.size();
  std::vector<Outcome> outcomes(count);
  std::vector<bool> done(count, false);
  std::atomic<size_t> next{0};
  std::mutex saying;
  size_t said = 0, finished = 0;
  {
    Progress progress("replay", count);
    // Outcomes are said in the order the files were given, as soon as all before them are known.
    const auto work = [&] {
      for (size_t i = next++; i < count; i = next++) {
        Outcome outcome = verifyOne(options.files[i], options, device);
        const std::lock_guard lock(saying);
        outcomes[i] = std::move(outcome);
        done[i] = true;
        progress.show(++finished);
        for (; said < count && done[said]; ++said) say(outcomes[said], quiet);
      }
    };
    std::vector<std::thread> helpers;
    for (size_t i = 1; i < std::min<size_t>(options.jobs, count); ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
  }

  for (const Outcome& outcome : outcomes) {
    if (count > 1) hashes.comment(outcome.file);
    for (size_t tick = 0; tick < outcome.hashes.size(); ++tick) hashes.write(uint32_t(tick + 1), outcome.hashes[tick]);
  }
  hashes.close();
  if (!quiet && device.cuda) std::printf("%s CUDA kernels run\n", withCommas(cudaKernelsRun).c_str());
  if (!options.jsonPath.empty()) {
    nlohmann::ordered_json json;
    json["exitCode"] = int(worst(outcomes));
    json["cudaKernelsRun"] = cudaKernelsRun.load();
    json["replays"] = nlohmann::ordered_json::array();
    for (const Outcome& outcome : outcomes) json["replays"].push_back(toJson(outcome));
    writeJson(options.jsonPath, json);
  }
  return worst(outcomes);
}

}  // namespace gw
