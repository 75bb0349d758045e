#include "game/overlay/overlay_figures.h"

#include <algorithm>
#include <numeric>

#include "game/overlay/broad_phase_switch.h"
#include "host/platform/clock.h"

namespace gw {

namespace {

const StageTime* findStage(const std::vector<StageTime>& times, const std::string& name) {
  const auto found = std::find_if(times.begin(), times.end(), [&](const StageTime& t) { return t.name == name; });
  return found == times.end() ? nullptr : &*found;
}

// Totals only grow, so a reading in which one is less, or gone, is not of the same simulation.
bool follows(const std::vector<StageTime>& before, const std::vector<StageTime>& now) {
  return std::all_of(before.begin(), before.end(), [&](const StageTime& old) {
    const StageTime* time = findStage(now, old.name);
    return time != nullptr && time->calls >= old.calls && time->total_ms >= old.total_ms;
  });
}

double perEntity(uint64_t count, uint64_t entities) {
  return entities == 0 ? 0 : double(count) / double(entities);
}

}  // namespace

std::vector<StageFigure> stageFigures(const std::vector<StageTime>& before, const std::vector<StageTime>& now) {
  if (!follows(before, now)) return stageFigures({}, now);
  std::vector<StageFigure> figures;
  for (const StageTime& time : now) {
    const StageTime* old = findStage(before, time.name);
    const uint64_t calls = time.calls - (old ? old->calls : 0);
    if (calls > 0) figures.push_back({time.name, (time.total_ms - (old ? old->total_ms : 0)) / double(calls)});
  }
  return figures;
}

double OverlayFigures::stages_ms() const {
  return std::accumulate(stages.begin(), stages.end(), 0.0,
                         [](double sum, const StageFigure& stage) { return sum + stage.perTick_ms; });
}

double OverlayFigures::candidatesPerEntity() const {
  return perEntity(candidates.tested, candidates.entities);
}

double OverlayFigures::neighboursPerEntity() const {
  return perEntity(candidates.found, candidates.entities);
}

uint32_t OverlayFigures::liveEnemies() const {
  return std::accumulate(std::begin(census.enemies), std::end(census.enemies), 0u);
}

std::optional<double> OverlayFigures::misaligned_percent() const {
  if (!census.misaligned) return {};
  return 100 * perEntity(*census.misaligned, census.searched);
}

void FigureGatherer::look(Simulation& simulation, double now_s) {
  if (figures_.known && now_s < next_s_) return;
  const double begin_s = gw::now_s();
  gather(simulation);
  const double took_s = gw::now_s() - begin_s;
  next_s_ = now_s + std::max(kEvery_s, took_s / kShare);
}

void FigureGatherer::gather(Simulation& simulation) {
  const SimulationConfig& config = simulation.config();
  figures_.device = simulation.deviceName();
  figures_.deviceBytes = simulation.deviceBytes();
  figures_.enemiesThatFit = config.enemies;
  figures_.broadPhase = config.broadPhase;
  figures_.gather = config.gather;
  figures_.sort = config.sortInUse();
  std::vector<StageTime> times = simulation.stageTimes();
  std::vector<StageFigure> stages = stageFigures(read_, times);
  if (!stages.empty()) figures_.stages = std::move(stages);
  read_ = std::move(times);
  figures_.census = simulation.census();
  const bool endless = config.broadPhase == BroadPhase::bruteForce && config.enemies > kMostForBruteForce;
  figures_.candidates = endless ? CandidateCount{} : simulation.countCandidates();
  figures_.known = true;
}

}  // namespace gw
