#include "game/session/run_factory.h"

#include <cstdio>
#include <random>

#include "host/platform/asset_folder.h"
#include "host/platform/atomic_file.h"
#include "host/platform/clock.h"
#include "host/platform/part_file.h"

namespace gw {

namespace {

std::filesystem::path numbered(const std::filesystem::path& path, uint32_t number) {
  if (number == 1) return path;
  std::filesystem::path result = path;
  result.replace_filename(path.stem().string() + "-" + std::to_string(number) + path.extension().string());
  return result;
}

// Recordings that were cut short stay beside the target until the user decides.
void sayWhatIsLeft(const std::filesystem::path& target) {
  const std::vector<std::filesystem::path> parts = partsLeftBeside(target);
  if (parts.empty()) return;
  const std::string first = parts.front().string();
  const std::string others = parts.size() == 1 ? "" : " (and " + std::to_string(parts.size() - 1) + " more like it)";
  std::fprintf(stderr,
               "%s%s is left of a recording that was cut short: watch it with 'gpuwars replay', make it whole with "
               "'gpuwars trim %s --out NAME.gwr', or delete it.\n",
               first.c_str(), others.c_str(), first.c_str());
}

}  // namespace

RunFactory::RunFactory(const PlayOptions& options)
    : options_(options),
      assets_(findAssetFolder(options.assetsDir)),
      device_(chooseDevice(options.device)),
      texts_(readRuleTexts(assets_)) {
  config_.rules = loadRules(texts_);
  config_.enemies = options.enemies;
  setComputing(config_, options);
  config_.particles = !options.headless || !options.screenshotPath.empty();  // drawn
  if (!options.recordPath.empty()) checkWritable(options.recordPath);        // before the game is played
}

std::unique_ptr<Run> RunFactory::make(Mode mode, uint64_t seed, Autopilot autopilot, bool recorded) {
  SimulationConfig config = config_;
  config.mode = mode;
  config.seed = seed;
  config.autopilot = autopilot;
  std::optional<Recorder> recorder;
  if (recorded && !options_.recordPath.empty()) {
    ReplayHeader header;
    header.seed = seed;
    header.mode = config.mode;
    header.enemies = config.enemies;
    header.autopilot = autopilot;
    header.options = options_.text;
    header.gather = config.gather;
    if (config.gather != Gather::exact) header.sort = config.sortInUse();
    recordPath_ = numbered(options_.recordPath, ++recordings_);
    sayWhatIsLeft(recordPath_);
    recorder.emplace(recordPath_, header, texts_);
  }
  return std::make_unique<Run>(makeLastingSimulation(device_, config), std::move(recorder));
}

std::unique_ptr<Simulation> RunFactory::makeAgain(const SimulationConfig& config) const {
  return makeLastingSimulation(device_, config);
}

uint64_t randomSeed() {
  std::random_device device;
  return (uint64_t(device()) << 32 | device()) ^ wallClock_ns();
}

}  // namespace gw
