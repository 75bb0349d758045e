// gpuwars verify FILE...: run replays again and compare every tick. Several files at a time with -j.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "game/cli/verify_options.h"
#include "game/commands/hash_file.h"
#include "game/commands/json_output.h"
#include "game/commands/progress.h"
#include "game/commands/verify_report.h"
#include "gpu/exec/kernel_count.h"
#include "host/platform/atomic_file.h"
#include "host/platform/interrupt.h"
#include "host/platform/number_format.h"

namespace gw {

namespace {

// The worst: a desync before a bad file before a run that failed.
ExitCode worst(const std::vector<Outcome>& outcomes) {
  ExitCode code = ExitCode::fine;
  for (const Outcome& outcome : outcomes) code = std::max(code, outcome.code);
  return code;
}

// Outcomes are printed in the order of the files, as soon as all before them are known.
std::vector<Outcome> verifyAll(const VerifyOptions& options, const DeviceChoice& device, bool quiet) {
  const size_t count = options.files.size();
  std::vector<Outcome> outcomes(count);
  std::vector<bool> done(count, false);
  std::atomic<size_t> next{0};
  std::mutex saying;
  size_t said = 0, finished = 0;
  std::atomic<uint64_t> ticks{0};
  Progress progress("replays verified", count);
  const auto show = [&] { progress.show(finished, ", " + withCommas(ticks) + " ticks"); };
  const std::function<void()> ticked = [&] {
    if (++ticks % 64 != 0) return;
    if (const std::unique_lock lock(saying, std::try_to_lock); lock) show();
  };
  const auto work = [&] {
    for (size_t i = next++; i < count; i = next++) {
      Outcome outcome = verifyReplay(options.files[i], options, device, ticked);
      const std::lock_guard lock(saying);
      outcomes[i] = std::move(outcome);
      done[i] = true;
      ++finished;
      if (done[said]) progress.clear();
      for (; said < count && done[said]; ++said) sayOutcome(outcomes[said], quiet);
      show();
    }
  };
  std::vector<std::thread> helpers;
  for (size_t i = 1; i < std::min<size_t>(options.jobs, count); ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  return outcomes;
}

void writeAsJson(const std::filesystem::path& path, const std::vector<Outcome>& outcomes) {
  nlohmann::ordered_json json;
  json["exitCode"] = exitStatus(int(worst(outcomes)));
  json["cudaKernelsRun"] = cudaKernelsRun.load();
  json["replays"] = nlohmann::ordered_json::array();
  for (const Outcome& outcome : outcomes) json["replays"].push_back(outcomeJson(outcome));
  writeJson(path, json);
}

}  // namespace

ExitCode runVerb(const VerifyOptions& options) {
  catchInterrupts();
  const DeviceChoice device = chooseDevice(options.device);
  HashFile hashes(options.hashesPath);
  for (const std::filesystem::path& path : {options.jsonPath, options.junitPath}) {
    if (!path.empty() && path != "-") checkWritable(path);  // before an hour of work
  }
  const bool quiet = hashes.isStdout() || options.jsonPath == "-";
  if (!quiet) sayWhy(device);

  const std::vector<Outcome> outcomes = verifyAll(options, device, quiet);

  for (const Outcome& outcome : outcomes) {
    if (outcomes.size() > 1) hashes.comment(outcome.file);
    for (size_t tick = 0; tick < outcome.hashes.size(); ++tick) hashes.write(uint32_t(tick + 1), outcome.hashes[tick]);
  }
  hashes.close();
  if (!quiet && device.cuda) std::printf("%s CUDA kernels run\n", withCommas(cudaKernelsRun).c_str());
  ExitCode code = worst(outcomes);
  // What cannot be written keeps neither the other from being written nor a desync from being told.
  const auto written = [&](const std::filesystem::path& path, const auto& write) {
    if (path.empty()) return;
    try {
      write();
    } catch (const FileError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      code = std::max(code, ExitCode::badFile);
    }
  };
  written(options.jsonPath, [&] { writeAsJson(options.jsonPath, outcomes); });
  written(options.junitPath, [&] {
    const std::string xml = junitXml(outcomes);
    writeFileAtomically(options.junitPath, {reinterpret_cast<const uint8_t*>(xml.data()), xml.size()});
  });
  return code;
}

}  // namespace gw
