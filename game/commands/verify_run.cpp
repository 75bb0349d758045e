#include "game/commands/verify_run.h"

#include <algorithm>
#include <cstring>

#include "game/commands/hash_file.h"
#include "game/desync/desync_text.h"
#include "game/desync/local_probe.h"
#include "game/desync/remote_probe.h"
#include "game/replay/replay_reader.h"
#include "gpu/devices/processors.h"
#include "gpu/exec/float_state.h"
#include "host/platform/clock.h"
#include "host/platform/interrupt.h"
#include "host/platform/user_error.h"

namespace gw {
namespace {

bool same(const Snapshot& a, const Snapshot& b) {
  return a.globals == b.globals && a.arrangement == b.arrangement && a.entities.size() == b.entities.size() &&
         (a.entities.empty() ||
          std::memcmp(a.entities.data(), b.entities.data(), a.entities.size() * sizeof(EntityRecord)) == 0);
}

class Verification {
 public:
  Verification(Outcome& outcome, const Replay& replay, const std::function<void()>& ticked)
      : outcome_(outcome), replay_(replay), ticked_(ticked) {
    outcome_.ticks = replay.ticks();
  }

  // Ticks are queued ahead. `heavy`: no; each tick's state is taken, put back, and taken again.
  void run(Simulation& simulation, bool heavy) {
    outcome_.device = simulation.deviceName();
    const uint32_t ahead = heavy ? 1 : Simulation::kTicksInFlight;
    uint32_t queued = 0;
    while (outcome_.compared < replay_.ticks() && !interrupted() && outcome_.wrong.empty()) {
      while (queued < replay_.ticks() && queued - outcome_.compared < ahead) simulation.tick(replay_.inputs[queued++]);
      hear(simulation.report());
      if (heavy && !outcome_.first) takeAndRestore(simulation);  // what is wrong already may not be restored
    }
  }

  void runBeside(Probe& own, Probe& reference) {
    outcome_.device = own.name();
    const Lockstep lockstep = playInLockstep(own, reference, replay_.ticks(), [](uint32_t) { return !interrupted(); });
    outcome_.desync = lockstep.desync;
    if (outcome_.desync) outcome_.compared = outcome_.desync->tick;  // both have played on for a little
  }

  void hear(const TickReport& report) {
    const uint32_t tick = outcome_.compared++;
    outcome_.hashes.push_back(report.hash);
    outcome_.facts.add(report);
    ticked_();
    if (report.hash != replay_.hashes[tick] && !outcome_.first) {
      outcome_.first = HashDifference{tick + 1, replay_.hashes[tick], report.hash};
    }
    if (outcome_.first && !outcome_.fields) compareFields(tick + 1, report);
  }

  void judge() {
    const TickReport& last = outcome_.facts.last;
    if (outcome_.desync || outcome_.first || !outcome_.wrong.empty()) {
      outcome_.code = ExitCode::desync;
    } else if (outcome_.compared < replay_.ticks()) {
      outcome_.error = "interrupted after " + std::to_string(outcome_.compared) + " of " +
                       std::to_string(replay_.ticks()) + " ticks; run it again to its end";
      outcome_.code = ExitCode::failedRun;
    } else if (replay_.result != FinalReport{last.score, last.kills, last.frameTime_us, last.over != 0}) {
      outcome_.wrong = "every tick is equal, but the recorded result is score " + std::to_string(replay_.result.score) +
                       ", computed " + std::to_string(last.score) + "; record it again.";
      outcome_.code = ExitCode::desync;
    } else {
      outcome_.code = ExitCode::fine;
    }
  }

 private:
  void takeAndRestore(Simulation& simulation) {
    const Snapshot taken = simulation.snapshot();
    simulation.restore(taken);
    if (same(taken, simulation.snapshot())) return;
    outcome_.wrong = "the snapshot of tick " + std::to_string(outcome_.compared) +
                     " is another one once it is restored; see game/sim/snapshot.cu.";
  }

  void compareFields(uint32_t tick, const TickReport& report) {
    const size_t kept = tick / kFieldHashesEvery_ticks;
    if (tick % kFieldHashesEvery_ticks != 0 || kept > replay_.fieldHashes.size()) return;
    FieldDifference& difference = outcome_.fields.emplace();
    difference.tick = tick;
    for (uint32_t field = 0; field < kHashFields; ++field) {
      if (report.fieldHashes[field] == replay_.fieldHashes[kept - 1][field]) continue;
      difference.fields.emplace_back(kHashFieldNames[field]);
    }
  }

  Outcome& outcome_;
  const Replay& replay_;
  const std::function<void()>& ticked_;
};

// What the reference's command line says after the file: its own options, and none of this one's, which an older build
// may not know.
std::vector<std::string> referenceArguments(const std::filesystem::path& file, const VerifyOptions& options) {
  std::vector<std::string> arguments{"probe", file.string()};
  for (size_t begin = 0; begin < options.referenceOptions.size();) {
    const size_t end = std::min(options.referenceOptions.find(' ', begin), options.referenceOptions.size());
    if (end > begin) arguments.push_back(options.referenceOptions.substr(begin, end - begin));
    begin = end + 1;
  }
  return arguments;
}

void playBeside(Outcome& outcome, Verification& verification, const Replay& replay, const SimulationConfig& config,
                const VerifyOptions& options, const DeviceChoice& device, const std::filesystem::path& file) {
  LocalProbe own([&] { return makeSimulation(device, config); }, replay.inputs,
                 [&](const TickReport& report) { verification.hear(report); });
  std::unique_ptr<Probe> reference;
  if (options.against) {
    const DeviceChoice other = chooseDevice(*options.against);
    reference = std::make_unique<LocalProbe>([other, config] { return makeSimulation(other, config); }, replay.inputs);
    outcome.reference = reference->name();
  } else {
    reference = std::make_unique<RemoteProbe>(options.reference, referenceArguments(file, options), interrupted);
    outcome.reference = reference->name() + ", " + options.reference.string();
  }
  verification.runBeside(own, *reference);
  if (!outcome.desync) return;
  outcome.recordedAtDesync = replay.hashes.at(outcome.desync->tick - 1);
  outcome.desyncText =
      desyncText(*outcome.desync, {outcome.device, outcome.reference, outcome.config.rules, outcome.recordedAtDesync});
}

}  // namespace

Outcome verifyReplay(const std::filesystem::path& file, const VerifyOptions& options, const DeviceChoice& device,
                     const std::function<void()>& ticked) {
  setFloatState();  // of this job's thread
  Outcome outcome;
  outcome.file = file.string();
  try {
    const Replay replay = readReplay(file);
    SimulationConfig config = replayConfig(replay);
    outcome.config = config;
    setComputingOf(config, options, outcome.file);
    const uint32_t jobs = std::min(options.jobs, uint32_t(options.files.size()));
    if (config.threads == 0 && jobs > 1) {  // the machine is shared between the jobs
      config.threads = std::max(1u, readProcessors().usable() / jobs);
    }
    Verification verification(outcome, replay, ticked);
    const double start_s = now_s();
    if (options.against || !options.reference.empty()) {
      playBeside(outcome, verification, replay, config, options, device, file);
    } else {
      verification.run(*makeSimulation(device, config), options.heavy);
    }
    outcome.seconds = now_s() - start_s;
    verification.judge();
  } catch (const UserError& error) {
    outcome.error = error.what();
    outcome.code = error.code;
  } catch (const std::bad_alloc&) {
    outcome.error = outcome.file + " needs more memory than there is: verify it on a larger machine.";
  } catch (const std::exception& error) {
    outcome.error = error.what();
  }
  if (outcome.first || outcome.desync) outcome.code = ExitCode::desync;  // whatever went wrong after it
  return outcome;
}

}  // namespace gw
