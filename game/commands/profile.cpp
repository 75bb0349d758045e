// gpuwars profile: a profiling session, from the command line to the folder of its report.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "game/cli/profile_options.h"
#include "game/commands/progress.h"
#include "game/profile/metrics/baseline.h"
#include "game/profile/report/frames_csv.h"
#include "game/profile/report/report_json.h"
#include "game/profile/report/summary.h"
#include "game/profile/report/write_report.h"
#include "game/profile/session/session.h"
#include "game/profile/session/trace.h"
#include "game/session/device_choice.h"
#include "host/platform/asset_folder.h"
#include "host/platform/atomic_file.h"
#include "host/platform/interrupt.h"
#include "host/platform/number_format.h"
#include "host/platform/user_error.h"

namespace gw {

namespace {

using namespace profile;

std::vector<ContenderChoice> contendersOf(const ProfileOptions& options) {
  const std::string list = options.compare.empty() ? nameOf(options.broadPhase) : options.compare;
  std::vector<ContenderChoice> contenders = parseContenders(list);
  for (ContenderChoice& contender : contenders) {
    if (contender.name != "ngrid" || !options.sort) continue;
    contender.sort = *options.sort;
    contender.about = fmt::format("NGrid, exact gather, --sort {}", nameOf(*options.sort));
  }
  return contenders;
}

SessionPlan planOf(const ProfileOptions& options) {
  SessionPlan plan;
  plan.scene = options.scene;
  plan.replay = options.replayPath;
  if (!options.enemiesList.empty()) plan.enemies = options.enemiesList;
  plan.ticks = options.seconds ? options.seconds * kTicksPerSecond : options.ticks;
  plan.runs = options.runs;
  plan.paced = options.paced;
  plan.contenders = contendersOf(options);
  plan.drawn = options.drawNothing ? Drawn::nothing : options.headless ? Drawn::offscreen : Drawn::window;
#ifndef GW_WINDOW
  if (plan.drawn == Drawn::window) {
    throw UserError(ExitCode::failedRun, "This build has no window: use --headless or --no-draw.");
  }
#endif
  plan.size = {int(options.width_px), int(options.height_px)};
  plan.look = {options.effects, options.glow, options.wholeWorld};
  return plan;
}

std::string durationText(double seconds) {
  if (!std::isfinite(seconds)) return "";
  if (seconds < 90) return fmt::format(", about {:.0f} s left", seconds);
  if (seconds < 5400) return fmt::format(", about {:.0f} min left", seconds / 60);
  return fmt::format(", about {:.1f} h left", seconds / 3600);
}

// What a session hands out while it runs: frames.csv and the trace, and how far it is.
class Outputs {
 public:
  Outputs(const ProfileOptions& options, const std::filesystem::path& folder) : options_(options), folder_(folder) {
    if (!options.tracePath.empty()) checkWritable(options.tracePath);
  }

  void take(uint32_t enemies, const ContenderChoice& contender, uint32_t run, const RunFrames& frames) {
    if (!csv_) csv_.emplace(folder_ / "frames.csv", frames.stages);
    csv_->begin(enemies, contender.name, run - 1, frames.stages);
    for (const Frame& frame : frames.frames) csv_->add(frame);
    if (run == 1 && !options_.tracePath.empty()) {
      trace_.add(fmt::format("{}, {} enemies", contender.name, withCommas(enemies)), frames);
    }
  }

  bool show(const SessionProgress& now) {
    if (now.doing != doing_) {
      doing_ = now.doing;
      progress_.reset();  // wipes its line
      progress_.emplace(doing_, now.ticks);
    }
    progress_->show(now.tick, durationText(now.left_s));
    return !interrupted();
  }

  void finishFrames() {
    progress_.reset();
    if (csv_) csv_->finish();
  }

  void writeTrace() const {
    if (options_.tracePath.empty()) return;
    const std::string text = trace_.json();
    writeFileAtomically(options_.tracePath, std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
  }

 private:
  const ProfileOptions& options_;
  std::filesystem::path folder_;
  std::optional<FramesCsv> csv_;
  Trace trace_;
  std::string doing_;
  std::optional<Progress> progress_;
};

ExitCode compare(const Report& report, const Report& baseline) {
  const Comparison comparison = compareWithBaseline(report, baseline);
  std::fputs(baselineText(comparison).c_str(), stdout);
  return comparison.gate == Gate::slower ? ExitCode::failedRun : ExitCode::fine;
}

}  // namespace

ExitCode runVerb(const ProfileOptions& options) {
  catchInterrupts();
  SessionPlan plan = planOf(options);
  std::optional<Report> baseline;
  if (!options.baselinePath.empty()) baseline = readReport(options.baselinePath);
  makeReportFolder(options.outPath);
  const DeviceChoice device = chooseDevice(options.device);
  SimulationConfig computing;
  setComputing(computing, options);
  sayWhy(device);
  Session session(std::move(plan), computing, findAssetFolder(options.assetsDir),
                  [device](const SimulationConfig& config) { return makeSimulation(device, config); });
  Outputs outputs(options, options.outPath);
  const auto comparable = [&](const Setup& setup) {
    const std::string why = baseline ? whyNotComparable(setup, baseline->setup) : "";
    if (!why.empty()) throw UserError(ExitCode::badFile, why);
  };
  const Report report = session.run(
      comparable, [&](auto&&... run) { outputs.take(run...); },
      [&](const SessionProgress& now) { return outputs.show(now); });
  outputs.finishFrames();
  const std::string note = writeReport(report, options.outPath);
  for (const std::string& sentence : summaryOf(report)) std::printf("%s\n", sentence.c_str());
  for (const std::string& warning : report.warnings) std::printf("Careful: %s\n", warning.c_str());
  if (!note.empty()) std::fprintf(stderr, "%s\n", note.c_str());
  std::printf("%s\n", (options.outPath / "report.html").c_str());
  const ExitCode code = baseline ? compare(report, *baseline) : ExitCode::fine;
  outputs.writeTrace();
  return code;
}

}  // namespace gw
