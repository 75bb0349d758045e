#include <initializer_list>
#include <type_traits>

#include "game/sim/debug/state_columns.h"
#include "game/sim/debug/state_members.h"
#include "game/sim/entity_copies.h"
#include "game/sim/step.h"

namespace gw::GW_DEVICE {
namespace {

template <class T>
uint64_t bitsOfValue(T value) {
  uint64_t bits = 0;  // little-endian, as is every machine that this is built for
  std::memcpy(&bits, &value, sizeof value);
  return bits;
}

class Reader {
 public:
  Reader(const GameState& state, const View& v, uint32_t stage, const StageState* before)
      : state_(state), v_(v), stage_(stage), before_(before) {}

  std::vector<Column> entities() {
    const auto side = [&](const char* writer) { return hasRun(writer) ? Side::end : Side::start; };
    const EntityCopies copies(state_, v_, side("integrate"), side("think"));
    std::vector<EntityRecord> all(v_.capacity);
    alive_.resize(v_.capacity);
    for (uint32_t id = 0; id < v_.capacity; ++id) {
      all[id] = copies.at(id);
      alive_[id] = all[id].type != kTypeNone;
    }
    for (const EntityField& field : kEntityFields) {
      const uint64_t ofNone = field.recordOffset == offsetof(EntityRecord, type) ? uint64_t(kTypeNone) : 0;
      add(field.column, field.isFloat ? ValueKind::real : ValueKind::whole, ofNone, [&](uint32_t id) {
        uint32_t bits;
        std::memcpy(&bits, reinterpret_cast<const char*>(&all[id]) + field.recordOffset, sizeof bits);
        return bits;
      });
    }
#define GW_BUFFER(name, Type, perId, since, ...) addWithinTick(state_.name, perId, since, {__VA_ARGS__});
    GW_TICK_BUFFERS(GW_BUFFER)
#undef GW_BUFFER
    // Last: where the arrangement is no state it may differ while the game does not.
    if (isArrangementState(v_.near.gather) && hasRun("maintain")) {
      add("cell", ValueKind::whole, 0, [&](uint32_t id) { return copies.cellOf[id]; });
    }
    return std::move(columns_);
  }

  std::vector<Column> globals() const {
    std::vector<Column> columns;
    GameGlobals globals;
    state_.globals.download(&globals, 1);
    addMembers(columns, "", kGlobalsMembers, &globals);
    TickScratch scratch;
    state_.scratch.download(&scratch, 1);
    if (!hasRun("logic")) {  // only the input is this tick's yet
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
  bool hasRun(const char* stage) const {
    return stage_ >= stageNumber(stage);
  }

  template <class Get>
  void add(const char* name, ValueKind kind, uint64_t ofNone, const Get& get) {
    std::vector<uint64_t> values(v_.capacity, ofNone);
    for (uint32_t id = 0; id < v_.capacity; ++id) {
      if (alive_[id]) values[id] = get(id);
    }
    columns_.push_back({name, kind, shared(name, std::move(values))});
  }

  // What the passes of one tick hand on: a column for each of the values per id.
  template <class T>
  void addWithinTick(const Buffer<T>& buffer, size_t perId, const char* since,
                     std::initializer_list<const char*> columns) {
    if (!hasRun(since)) return;
    const std::vector<T> values = buffer.download();
    size_t k = 0;
    for (const char* column : columns) {
      add(column, std::is_floating_point_v<T> ? ValueKind::real : ValueKind::whole, 0,
          [&](uint32_t id) { return bitsOfValue(values[perId * id + k]); });
      ++k;
    }
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
  Reader reader(state, v, stageNumber(stage), before);
  return {stage, reader.entities(), reader.globals()};
}

}  // namespace gw::GW_DEVICE
