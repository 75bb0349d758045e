#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "game/sim/debug/state_columns.h"
#include "game/sim/debug/state_members.h"

namespace gw::GW_DEVICE {
namespace {

constexpr const char* kStages[] = {"autopilot", "logic",   "spawn",  "maintain", "think",
                                   "integrate", "collide", "settle", "hash"};

// From which stage on a field belongs to the running tick.
enum Since : uint32_t { kStart, kLogic, kSpawn, kMaintain, kThink, kIntegrate, kCollide };

uint32_t numberOf(const std::string& stage) {
  const auto found = std::find(std::begin(kStages), std::end(kStages), stage);
  if (found == std::end(kStages)) throw std::logic_error("There is no stage '" + stage + "' in a tick.");
  return uint32_t(found - std::begin(kStages));
}

uint64_t bitsOfReal(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

class Reader {
 public:
  Reader(const GameState& state, const View& v, uint32_t stage, const StageState* before)
      : state_(state), v_(v), stage_(stage), before_(before) {}

  std::vector<Column> entities() {
    const bool moved = stage_ >= kIntegrate, thought = stage_ >= kThink;
    const auto cells = sideOf(state_.cells, moved ? v_.moved : v_.cells).download();
    const auto cellOf = state_.cellOf.download();
    // Damage is what is looked for here: an id may name a cell that there is none of.
    const auto cell = [&](uint32_t id) {
      return cellOf[id] < cells.size() ? cells[cellOf[id]] : Cell{kInfinity, kInfinity, id, kTypeNone};
    };
    alive_.resize(v_.capacity);
    for (uint32_t id = 0; id < v_.capacity; ++id) alive_[id] = cell(id).type != kTypeNone;
    whole(
        "type", kStart, [&](uint32_t id) { return cell(id).type; }, kTypeNone);
    real("x", kStart, [&](uint32_t id) { return cell(id).x; });
    real("y", kStart, [&](uint32_t id) { return cell(id).y; });
    const auto motion = state_.velocityPrevious.download();
    real("velocity_x", kStart, [&](uint32_t id) { return motion[id].x; });
    real("velocity_y", kStart, [&](uint32_t id) { return motion[id].y; });
    real("previous_x", kStart, [&](uint32_t id) { return motion[id].z; });
    real("previous_y", kStart, [&](uint32_t id) { return motion[id].w; });
    const auto force = sideOf(state_.forceEnergy, thought ? v_.nextForceEnergy : v_.forceEnergy).download();
    real("force_x", kStart, [&](uint32_t id) { return force[id].x; });
    real("force_y", kStart, [&](uint32_t id) { return force[id].y; });
    real("energy", kStart, [&](uint32_t id) { return force[id].w; });
    const auto direction = sideOf(state_.directionMass, thought ? v_.nextDirectionMass : v_.directionMass).download();
    real("direction_x", kStart, [&](uint32_t id) { return direction[id].x; });
    real("direction_y", kStart, [&](uint32_t id) { return direction[id].y; });
    real("mass", kStart, [&](uint32_t id) { return direction[id].z; });
    const auto push = state_.push.download();
    real("push_x", kStart, [&](uint32_t id) { return push[id].x; });
    real("push_y", kStart, [&](uint32_t id) { return push[id].y; });
    const auto machine = state_.state.download();
    whole("state", kStart, [&](uint32_t id) { return machine[id].x; });
    whole("timer", kStart, [&](uint32_t id) { return machine[id].y; });
    whole("cooldown", kStart, [&](uint32_t id) { return machine[id].z; });
    whole("flags", kStart, [&](uint32_t id) { return machine[id].w; });
    plain("birth_tick", kStart, state_.birthTick);
    plain("target", kStart, state_.target);
    plain("threat", kThink, state_.threat);
    plain("event", kThink, state_.event);
    collisions();
    // Last: where the arrangement is no state it may differ while the game does not.
    if (isArrangementState(v_.near.gather)) whole("cell", kMaintain, [&](uint32_t id) { return cellOf[id]; });
    return std::move(columns_);
  }

  std::vector<Column> globals() const {
    std::vector<Column> columns;
    Master master;
    state_.master.download(&master, 1);
    addMembers(columns, "", kMasterMembers, &master);
    TickScratch scratch;
    state_.scratch.download(&scratch, 1);
    if (stage_ < kLogic) {  // only the input is this tick's yet
      TickScratch begun;
      begun.input = scratch.input;
      scratch = begun;
    }
    addMembers(columns, "tick.", kScratchMembers, &scratch);
    for (uint32_t c = 0; c < kMaxCommands; ++c) {
      const Command command = c < scratch.commandCount ? scratch.commands[c] : Command{};
      addMembers(columns, "command[" + std::to_string(c) + "].", kCommandMembers, &command);
    }
    return columns;
  }

 private:
  template <class Get>
  void add(const char* name, ValueKind kind, uint32_t since, const Get& get, uint64_t nobody) {
    if (stage_ < since) return;
    std::vector<uint64_t> values(v_.capacity, nobody);
    for (uint32_t id = 0; id < v_.capacity; ++id) {
      if (alive_[id]) values[id] = get(id);
    }
    columns_.push_back({name, kind, shared(name, std::move(values))});
  }
  template <class Get>
  void whole(const char* name, uint32_t since, const Get& get, uint64_t nobody = 0) {
    add(name, ValueKind::whole, since, get, nobody);
  }
  template <class Get>
  void real(const char* name, uint32_t since, const Get& get) {
    add(
        name, ValueKind::real, since, [&](uint32_t id) { return bitsOfReal(get(id)); }, 0);
  }
  template <class T>
  void plain(const char* name, uint32_t since, const Buffer<T>& buffer) {
    if (stage_ < since) return;
    const auto values = buffer.download();
    whole(name, since, [&](uint32_t id) { return values[id]; });
  }

  // What collide's passes tell each other.
  void collisions() {
    if (stage_ < kCollide) return;
    const auto choice = state_.choice.download();
    const auto time = state_.choiceTime.download();
    whole("choice", kCollide, [&](uint32_t id) { return choice[id]; });
    real("choice_time", kCollide, [&](uint32_t id) { return choice[id] == kNobody ? 0.0f : time[id]; });
    plain("chosen_by", kCollide, state_.chosenBy);
    plain("spent", kCollide, state_.spent);
    const auto sums = state_.pushSum.download();
    whole("push_sum_x", kCollide, [&](uint32_t id) { return sums[3 * size_t(id)]; });
    whole("push_sum_y", kCollide, [&](uint32_t id) { return sums[3 * size_t(id) + 1]; });
    whole("push_lengths", kCollide, [&](uint32_t id) { return sums[3 * size_t(id) + 2]; });
  }

  std::shared_ptr<const std::vector<uint64_t>> shared(const std::string& name, std::vector<uint64_t> values) const {
    if (before_) {
      for (const Column& column : before_->entities) {
        if (column.name == name && *column.values == values) return column.values;
      }
    }
    return std::make_shared<const std::vector<uint64_t>>(std::move(values));
  }

  const GameState& state_;
  const View& v_;
  uint32_t stage_;
  const StageState* before_;
  std::vector<bool> alive_;
  std::vector<Column> columns_;
};

}  // namespace

StageState readState(const GameState& state, const View& v, const std::string& stage, const StageState* before) {
  Reader reader(state, v, numberOf(stage), before);
  return {stage, reader.entities(), reader.globals()};
}

}  // namespace gw::GW_DEVICE
