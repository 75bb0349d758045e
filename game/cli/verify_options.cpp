#include "game/cli/verify_options.h"

#include "host/cli/option_set.h"

namespace gw {
namespace {

constexpr Choice<DeviceOption> kAgainst[] = {{"cuda", DeviceOption::cuda}, {"cpu", DeviceOption::cpu}};

}  // namespace

void VerifyOptions::declare(OptionSet& options) {
  declareComputing(options, GameSource::replay);
  options.files("FILE", "the replays to run again", 1, SIZE_MAX, files);
  options.integer("-j,--jobs", "how many replays run at the same time (1)", 1, 256, jobs);
  options.path("--json", "write the results as JSON to OUT ('-': stdout)", "OUT", jsonPath);
  options.path("--hashes", "write one line per tick to OUT ('-': stdout)", "OUT", hashesPath);
  options.flag("--heavy", "take and restore a snapshot after every tick", heavy);
  options.flag("--shuffle", "the cpu device visits items in shuffled order, as with --order shuffled",
               [this] { order = VisitOrder::shuffled; });
  options.choice("--against", kAgainst, "run another device in lockstep and locate the first difference", "none",
                 against);
  options.path("--reference", "run another build of gpuwars in lockstep and locate the first difference", "PROGRAM",
               reference);
  options.text("--reference-options", "options of the reference, such as '--threads 1'", "TEXT",
               [this](const std::string& given) { referenceOptions = given; });
  options.path("--junit", "write the results as JUnit XML to OUT", "OUT", junitPath);
  options.exclude("--against", "cannot be combined with", "--reference");
  options.exclude("--heavy", "cannot be combined with", "--against");
  options.exclude("--heavy", "cannot be combined with", "--reference");
}

void VerifyOptions::check() {
  checkComputing(GameSource::replay);
  if (!jsonPath.empty() && jsonPath == hashesPath) {
    throw UsageError("'--json' and '--hashes' name the same file; give each its own");
  }
  if (!junitPath.empty() && (junitPath == hashesPath || junitPath == jsonPath)) {
    throw UsageError("'--junit' and '--json' or '--hashes' name the same file; give each its own");
  }
  if (!referenceOptions.empty() && reference.empty()) {
    throw UsageError("'--reference-options' needs '--reference PROGRAM'; add it");
  }
}

}  // namespace gw
