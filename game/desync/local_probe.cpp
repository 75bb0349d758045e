#include "game/desync/local_probe.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "game/replay/checksum.h"

namespace gw {
namespace {

uint64_t hashOf(std::span<const uint64_t> values) {
  return replayChecksum({reinterpret_cast<const uint8_t*>(values.data()), values.size_bytes()});
}

std::span<const uint64_t> blockOf(const std::vector<uint64_t>& values, size_t block) {
  const size_t begin = std::min(block * kBlockIds, values.size());
  return std::span(values).subspan(begin, std::min<size_t>(kBlockIds, values.size() - begin));
}

}  // namespace

LocalProbe::LocalProbe(Make make, std::vector<InputRecord> inputs, Told told)
    : make_(std::move(make)), inputs_(std::move(inputs)), told_(std::move(told)), simulation_(make_()) {}

void LocalProbe::restart() {
  simulation_.reset();  // first: two may not fit
  simulation_ = make_();
  stages_.clear();
  tick_ = 0;
}

void LocalProbe::hear(const TickReport& report) {
  ++tick_;
  if (tick_ <= heard_) return;
  heard_ = tick_;
  if (told_) told_(report);
}

std::vector<uint64_t> LocalProbe::play(uint32_t ticks) {
  stages_.clear();
  ticks = std::min<uint32_t>(ticks, uint32_t(inputs_.size()) - tick_);
  std::vector<uint64_t> hashes;
  uint32_t queued = 0;
  const uint32_t first = tick_;
  while (hashes.size() < ticks) {
    while (queued < ticks && queued - hashes.size() < Simulation::kTicksInFlight) {
      simulation_->tick(inputs_[first + queued++]);
    }
    const TickReport report = simulation_->report();
    hear(report);
    hashes.push_back(report.hash);
  }
  return hashes;
}

void LocalProbe::keep() {
  kept_ = simulation_->snapshot();
  keptTick_ = tick_;
}

void LocalProbe::goBack() {
  if (!kept_) return restart();
  stages_.clear();
  simulation_->restore(*kept_);
  tick_ = keptTick_;
}

std::vector<StageHashes> LocalProbe::playByStages() {
  if (tick_ >= inputs_.size()) throw std::logic_error("The run has no further tick.");
  stages_.clear();
  Inspection& inspection = simulation_->inspection();
  hear(inspection.tickByStages(inputs_[tick_], [&](const std::string& stage) {
    stages_.push_back(inspection.stateAfter(stage, stages_.empty() ? nullptr : &stages_.back()));
  }));
  std::vector<StageHashes> hashes;
  for (const StageState& state : stages_) {
    StageHashes& of = hashes.emplace_back();
    of.stage = state.stage;
    for (const Column& column : state.entities) of.entities.push_back({column.name, hashOf(*column.values)});
    for (const Column& column : state.globals) of.globals.push_back({column.name, hashOf(*column.values)});
  }
  return hashes;
}

const StageState& LocalProbe::stageOf(const std::string& stage) const {
  for (const StageState& state : stages_) {
    if (state.stage == stage) return state;
  }
  throw std::invalid_argument("No tick was played by stages that has a stage '" + stage + "'.");
}

const Column& LocalProbe::columnOf(const std::string& stage, const std::string& field) const {
  for (const Column& column : stageOf(stage).entities) {
    if (column.name == field) return column;
  }
  throw std::invalid_argument("Entities have no field '" + field + "' after the stage '" + stage + "'.");
}

std::vector<uint64_t> LocalProbe::blocks(const std::string& stage, const std::string& field) {
  const std::vector<uint64_t>& values = *columnOf(stage, field).values;
  std::vector<uint64_t> hashes;
  for (size_t block = 0; block * kBlockIds < values.size(); ++block) hashes.push_back(hashOf(blockOf(values, block)));
  return hashes;
}

std::vector<uint64_t> LocalProbe::values(const std::string& stage, const std::string& field, uint32_t block) {
  const std::span<const uint64_t> of = blockOf(*columnOf(stage, field).values, block);
  return {of.begin(), of.end()};
}

FieldValue LocalProbe::global(const std::string& stage, const std::string& field) {
  for (const Column& column : stageOf(stage).globals) {
    if (column.name == field) return {field, column.kind, column.values->front()};
  }
  throw std::invalid_argument("There is no global '" + field + "' after the stage '" + stage + "'.");
}

std::vector<FieldValue> LocalProbe::entity(const std::string& stage, uint32_t id) {
  std::vector<FieldValue> values;
  for (const Column& column : stageOf(stage).entities) {
    values.push_back({column.name, column.kind, column.values->at(id)});
  }
  return values;
}

std::vector<NearEntity> LocalProbe::around(const std::string& stage, uint32_t id, uint32_t count) {
  const std::vector<Column>& columns = stageOf(stage).entities;
  const auto real = [&](size_t column, uint32_t of) {
    return std::bit_cast<float>(uint32_t(columns[column].values->at(of)));
  };
  const auto typeOf = [&](uint32_t of) { return uint32_t(columns[0].values->at(of)); };
  std::vector<NearEntity> near;
  if (typeOf(id) == kTypeNone) return near;
  for (uint32_t other = 0; other < columns[0].values->size(); ++other) {
    if (other == id || typeOf(other) == kTypeNone) continue;
    const double dx = double(real(1, other)) - real(1, id), dy = double(real(2, other)) - real(2, id);
    const float distance2 = float(dx * dx + dy * dy);
    if (std::isfinite(distance2)) near.push_back({other, typeOf(other), distance2});  // a place may be what is damaged
  }
  const auto nearer = [](const NearEntity& a, const NearEntity& b) {
    return a.distance_m != b.distance_m ? a.distance_m < b.distance_m : a.id < b.id;
  };
  const size_t kept = std::min<size_t>(count, near.size());
  std::partial_sort(near.begin(), near.begin() + kept, near.end(), nearer);
  near.resize(kept);
  for (NearEntity& entity : near) entity.distance_m = std::sqrt(entity.distance_m);
  return near;
}

}  // namespace gw
