#include "game/profile/session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/profile/metrics/contender_figures.h"
#include "game/ui/mode_choice.h"
#include "host/platform/clock.h"
#include "host/platform/number_format.h"
#include "host/platform/user_error.h"

namespace gw::profile {
namespace {

constexpr uint32_t kWarmUp_ticks = 120;         // caches, clocks of the processor, the first births
constexpr double kBusy = 0.05, kSpread = 0.05;  // shares from which the reader is warned

// What timing the stages adds to a tick, as a share: ticks that were timed against others that were not, in the same
// beat of the game: bots decide every fourth tick, and much else happens every second or fourth.
double stageTimersCost(const RunFrames& run) {
  constexpr size_t kBeat = 4;
  std::vector<double> ratios;
  for (size_t i = kBeat; i + kBeat < run.frames.size(); ++i) {
    const Frame &before = run.frames[i - kBeat], &frame = run.frames[i], &after = run.frames[i + kBeat];
    if (frame.warmUp || before.staged != after.staged || frame.staged == before.staged) continue;
    const double around = (tick_ms(before) + tick_ms(after)) / 2;  // unknown when one had no tick
    const double ratio = frame.staged ? tick_ms(frame) / around : around / tick_ms(frame);
    if (std::isfinite(ratio)) ratios.push_back(ratio);
  }
  return ratios.empty() ? kUnknown : median(std::move(ratios)) - 1;
}

// Standard deviation of the runs' means over their mean; unknown of fewer than two.
double spreadOf(const Contender& contender, const char* metric) {
  std::vector<double> means;
  for (const MetricValues& run : contender.runs) {
    if (const auto found = run.find(metric); found != run.end()) means.push_back(found->second);
  }
  return means.size() < 2 ? kUnknown : deviation(means) / mean(means);
}

const char* aboutDrawn(Drawn drawn) {
  return drawn == Drawn::window ? "window" : "offscreen";
}

}  // namespace

// One case while it is played.
struct Session::CaseRuns {
  Runner runner;
  RunPlan plan;
  std::vector<ContenderFigures> figures = {};  // by contender
  std::vector<std::string> hashes = {};
  std::vector<uint32_t> runs = {};  // that count
  std::vector<bool> cut = {};       // the only run it has was ended
};

Session::Session(SessionPlan plan, SimulationConfig computing, std::filesystem::path assets, MakeSimulation device)
    : plan_(std::move(plan)),
      computing_(std::move(computing)),
      assets_(std::move(assets)),
      device_([make = std::move(device), this](SimulationConfig config) {
        config.threads = computing_.threads;
        config.order = computing_.order;
        config.protectMemory = computing_.protectMemory;
        config.blockSize = computing_.blockSize;
        config.checkLaunches = computing_.checkLaunches;
        return make(config);
      }),
      rules_(readRuleTexts(assets_)),
      tickCost_s_(plan_.contenders.size()),
      ticksToGo_(plan_.contenders.size()) {}

Session::~Session() = default;

Report Session::run(const SetupListener& setups, const RunListener& runs, const ProgressListener& progress) {
  runListener_ = runs;
  progressListener_ = progress;
  const MachineUse use;
  const ProcessorWatch processors;
  Report report;
  report.machine = thisMachine();
  begin();
  for (size_t i = 0; i < plan_.enemies.size() && !ended_; ++i) {
    Scene scene = sceneFor(plan_.enemies[i]);
    if (ended_) break;
    cutTo(scene, plan_.ticks);
    Case played = playCase(scene, i, setups);
    if (!played.contenders.empty()) report.cases.push_back(std::move(played));
  }
  report.setup = setup_;
  if (report.cases.empty()) {
    throw UserError(ExitCode::failedRun, "Interrupted before a single frame was measured; start it again.");
  }
  report.setup.interrupted = ended_;
  tellGpu(report.machine, gpu_);
  if (screen_) report.machine.renderer = screen_->context->rendererName();
  report.growth = growthOf(report.cases);
  if (!timersCost_.empty()) report.stageTimersCost = median(timersCost_);
  warn(report, use, processors);
  return report;
}

Scene Session::sceneFor(uint32_t enemies) {
  if (!plan_.replay.empty()) {
    Scene scene = readScene(plan_.replay);
    if (plan_.ticks > scene.replay.ticks()) {
      throw UserError(ExitCode::badFile,
                      fmt::format("{} has {} ticks, and {} were asked for: ask for fewer, or leave them out.",
                                  plan_.replay.string(), scene.replay.ticks(), plan_.ticks));
    }
    if (scene.replay.header.gather == Gather::exact) return scene;
    throw UserError(ExitCode::badFile, plan_.replay.string() +
                                           " was recorded with an inexact gather, a game that no exact contender "
                                           "plays: give a replay of an exact game.");
  }
  const uint32_t ticks = plan_.ticks ? plan_.ticks : usualTicks(plan_.scene);
  if (plan_.scene == SceneKind::fiveMinutes && enemies == 8192 && ticks <= usualTicks(plan_.scene)) {
    return readFiveMinutes(assets_);
  }
  const std::string doing = fmt::format("recording {} with {} enemies", nameOf(plan_.scene), withCommas(enemies));
  const double start_s = now_s();
  return recordScene(plan_.scene, {enemies, ticks}, rules_, device_, [&](uint32_t tick) {
    return tell(doing, tick, ticks, (now_s() - start_s) * (ticks - tick) / tick);  // of the recording alone
  });
}

// What draws is found, or missed, before a scene is recorded for minutes; what computes decides which it is.
void Session::begin() {
  if (plan_.drawn == Drawn::nothing) return;
  Replay smallest;
  smallest.header.enemies = 1;
  smallest.rules = rules_;
  openScreen(make(replayConfig(smallest))->onCuda());
}

void Session::openScreen(bool onCuda) {
  if (plan_.drawn == Drawn::nothing || screen_) return;
#ifdef GW_WINDOW
  if (plan_.drawn == Drawn::window) screen_ = openWindow(plan_.size);
#endif
  if (!screen_) screen_ = openOffscreen(plan_.size, onCuda);
  size_ = screen_->context->size();
}

// The first one says what the device is.
std::unique_ptr<Simulation> Session::make(const SimulationConfig& config) {
  std::unique_ptr<Simulation> simulation = device_(config);
  if (deviceName_.empty()) deviceName_ = simulation->deviceName();
  if (simulation->deviceName() == deviceName_) return simulation;
  throw UserError(ExitCode::failedRun, fmt::format("The session began on {} and would go on with {}, which compares "
                                                   "nothing: choose fewer enemies, or '--device cpu'.",
                                                   deviceName_, simulation->deviceName()));
}

Case Session::playCase(const Scene& scene, size_t index, const SetupListener& setups) {
  Case played;
  played.enemies = scene.replay.header.enemies;
  SimulationConfig config = replayConfig(scene.replay);
  make(config);  // a game that does not fit is refused before anything is drawn or printed
  std::optional<Picture> picture;
  if (screen_) picture.emplace(*screen_, assets_, plan_.look);
  const uint32_t ticks = scene.replay.ticks();
  if (index == 0) setups(setup_ = setupOf(scene));
  const MakeSimulation same = [this](const SimulationConfig& asked) { return make(asked); };
  CaseRuns of{Runner(scene, config, same, picture ? &*picture : nullptr),
              {ticks, std::min(kWarmUp_ticks, ticks / 4), plan_.paced}};
  for (const ContenderChoice& contender : plan_.contenders) of.figures.emplace_back(contender.name, contender.about);
  of.hashes.resize(plan_.contenders.size());
  of.runs.resize(plan_.contenders.size());
  of.cut.resize(plan_.contenders.size());
  const uint64_t casesToGo = plan_.enemies.size() - index;
  std::fill(ticksToGo_.begin(), ticksToGo_.end(), casesToGo * plan_.runs * ticks);
  for (uint32_t round = 0; round < plan_.runs && !ended_; ++round) {
    for (size_t contender = 0; contender < plan_.contenders.size() && !ended_; ++contender) {
      playRun(scene, played.enemies, round, of, contender);
    }
  }
  finish(played, of);
  return played;
}

// Nothing is compared with a run that was cut: what it lacks may be what costs most.
void Session::finish(Case& played, const CaseRuns& of) {
  for (size_t i = 0; i < plan_.contenders.size(); ++i) {
    if (of.runs[i] == 0) continue;
    played.contenders.push_back(of.figures[i].finish());
    Contender& contender = played.contenders.back();
    if (!plan_.contenders[i].shadow()) contender.hash = of.hashes[i];
    if (played.contenders.size() == 1) continue;
    if (of.cut[i] || of.cut[0]) {
      played.speedUps.push_back({contender.name, kNoEstimate, kNoEstimate, kNoEstimate});
      cutShort_.push_back(fmt::format("{} at {} enemies", contender.name, withCommas(played.enemies)));
      continue;
    }
    SpeedUp speedUp = speedUpOf(played.contenders.front(), contender);
    // A shadow draws nothing: its caches are its own, those of the others OpenGL's too.
    if (contender.shadow && screen_) speedUp.upkeepAndGathering = kNoEstimate;
    played.speedUps.push_back(std::move(speedUp));
  }
}

// A run that was ended early counts only where its contender has no other: it is shorter than they are.
void Session::playRun(const Scene& scene, uint32_t enemies, uint32_t round, CaseRuns& of, size_t contender) {
  const ContenderChoice& choice = plan_.contenders[contender];
  const std::string doing = fmt::format("{}, {} enemies: run {} of {}, {}", scene.name, withCommas(enemies), round + 1,
                                        plan_.runs, choice.name);
  const double start_s = now_s();
  uint32_t done = 0;
  const PlayedRun run = of.runner.play(choice, of.plan, [&](const Frame& frame) {
    ticksToGo_[contender] -= frame.ticks;
    done = frame.tick;
    if (done > of.plan.warmUp_ticks) tickCost_s_[contender] = (now_s() - start_s) / done;
    return tell(doing, frame.tick, of.plan.ticks, left_s());
  });
  if (!run.whole) ended_ = true;
  if (run.frames.frames.empty() || (!run.whole && of.runs[contender] > 0)) return;
  of.figures[contender].add(run.frames);
  if (run.whole) of.hashes[contender] = fmt::format("{:016x}", run.hash);
  of.cut[contender] = !run.whole;
  const double cost = stageTimersCost(run.frames);
  if (std::isfinite(cost)) timersCost_.push_back(cost);
  ++of.runs[contender];
  ++madeRuns_;
  if (const auto state = askGpu(deviceName_)) gpu_.push_back(*state);  // while its clocks are still up
  runListener_(enemies, choice, round + 1, run.frames);
}

bool Session::tell(const std::string& doing, uint32_t tick, uint32_t ticks, double left_s) {
  const bool open = !screen_ || !screen_->open || screen_->open();
  if (!progressListener_({doing, tick, ticks, left_s}) || !open) ended_ = true;
  return !ended_;
}

// Contenders that have not run yet are taken to be as fast as the mean of those that have.
double Session::left_s() const {
  double known_s = 0, sum_s = 0;
  size_t knownCount = 0;
  for (const double cost_s : tickCost_s_) {
    known_s += cost_s;
    knownCount += cost_s > 0;
  }
  if (knownCount == 0) return kUnknown;
  for (size_t i = 0; i < tickCost_s_.size(); ++i) {
    sum_s += double(ticksToGo_[i]) * (tickCost_s_[i] > 0 ? tickCost_s_[i] : known_s / double(knownCount));
  }
  return sum_s;
}

Setup Session::setupOf(const Scene& first) const {
  Setup setup;
  setup.scene = first.name;
  setup.about = first.about;
  setup.mode = modeName(first.replay.header.mode);
  setup.device = deviceName_;
  setup.drawn =
      plan_.drawn == Drawn::nothing
          ? "nothing: simulation only"
          : fmt::format("{} {}x{}{}{}{}", aboutDrawn(plan_.drawn), size_.width, size_.height,
                        plan_.look.wholeWorld ? ", the whole world" : "", plan_.look.effects ? "" : ", effects off",
                        plan_.look.glow == kGlowLow   ? ""
                        : plan_.look.glow == kGlowOff ? ", glow off"
                                                      : ", glow high");
  setup.pacing = plan_.paced ? "real time" : "a tick a frame";
  setup.ticks = first.replay.ticks();
  setup.warmUp = std::min(kWarmUp_ticks, setup.ticks / 4);
  setup.runs = plan_.runs;
  return setup;
}

void Session::warn(Report& report, const MachineUse& use, const ProcessorWatch& processors) const {
  report.machine.loadAfter = loadAverage();
  report.machine.processors = processors.state();
  for (const std::string& sentence : processors.warnings(*report.machine.processors)) {
    report.warnings.push_back(sentence);
  }
  const double others = use.othersShare();
  if (others > kBusy) {
    report.warnings.push_back(fmt::format(
        "{} took {:.0f} % of the processors' time meanwhile: figures are noisy; measure again on an idle "
        "machine.",
        plan_.drawn == Drawn::window ? "Other programs, the display's among them," : "Other programs", 100 * others));
  }
  if (plan_.runs < kRunsForInterval) {
    report.warnings.push_back(fmt::format("{} run{} too few for intervals: ask for --runs {} or more.", plan_.runs,
                                          plan_.runs == 1 ? " is" : "s are", kRunsForInterval));
  }
  for (const Case& played : report.cases) {
    for (const Contender& contender : played.contenders) {
      const double spread = spreadOf(contender, screen_ ? "frame_ms.mean" : "tick_ms.mean");
      if (!(spread > kSpread)) continue;
      report.warnings.push_back(
          fmt::format("The runs of {} at {} enemies differ by {:.0f} %: the machine was busy or changed its clocks.",
                      contender.name, withCommas(played.enemies), 100 * spread));
    }
  }
  if (screen_ && (screen_->context->size().width != size_.width || screen_->context->size().height != size_.height)) {
    report.warnings.push_back("The window changed its size meanwhile: its frames are of two kinds; measure again.");
  }
  for (const std::string& contender : cutShort_) {
    report.warnings.push_back(contender +
                              " is not compared: a run of it, or of the first contender, was cut short and "
                              "is the only one.");
  }
  if (report.setup.interrupted) {
    report.warnings.push_back(
        fmt::format("Interrupted after {} run{}: this is what there was.", madeRuns_, madeRuns_ == 1 ? "" : "s"));
  }
}

}  // namespace gw::profile
