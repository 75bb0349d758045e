#include "tests/game/sim/stage_fixture.h"

#include <cstddef>
#include <cstring>

#include "game/sim/snapshot.h"
#include "game/tables/tables.h"

namespace gw::test {
namespace {

struct Field {
  const char* name;
  size_t offset;
  bool isFloat;
};

#define GW_FLOAT(type, name) \
  { #name, offsetof(type, name), true }
#define GW_WORD(type, name) \
  { #name, offsetof(type, name), false }
constexpr Field kEntityFields[] = {
    GW_WORD(EntityRecord, id),           GW_WORD(EntityRecord, type),         GW_FLOAT(EntityRecord, x),
    GW_FLOAT(EntityRecord, y),           GW_FLOAT(EntityRecord, previous_x),  GW_FLOAT(EntityRecord, previous_y),
    GW_FLOAT(EntityRecord, velocity_x),  GW_FLOAT(EntityRecord, velocity_y),  GW_FLOAT(EntityRecord, force_x),
    GW_FLOAT(EntityRecord, force_y),     GW_FLOAT(EntityRecord, energy),      GW_FLOAT(EntityRecord, mass),
    GW_FLOAT(EntityRecord, direction_x), GW_FLOAT(EntityRecord, direction_y), GW_FLOAT(EntityRecord, push_x),
    GW_FLOAT(EntityRecord, push_y),      GW_WORD(EntityRecord, state),        GW_WORD(EntityRecord, timer),
    GW_WORD(EntityRecord, cooldown),     GW_WORD(EntityRecord, flags),        GW_WORD(EntityRecord, birthTick),
    GW_WORD(EntityRecord, target)};
static_assert(sizeof kEntityFields / sizeof kEntityFields[0] * 4 == sizeof(EntityRecord), "a field is missing");
#undef GW_FLOAT
#undef GW_WORD

template <class T>
T at(const void* record, size_t offset) {
  T value;
  std::memcpy(&value, static_cast<const char*>(record) + offset, sizeof value);
  return value;
}

template <class T>
T onlyOne(const cpu::Buffer<T>& buffer) {
  T value;
  buffer.download(&value, 1);
  return value;
}

}  // namespace

const Rules& gameRules() {
  static const Rules rules = loadRules(readRuleTexts(GW_ASSETS_DIR));
  return rules;
}

SimulationConfig stageConfig(uint32_t enemies) {
  SimulationConfig config;
  config.rules = gameRules();
  config.enemies = enemies;
  config.threads = 1;
  return config;
}

StageFixture::StageFixture(const SimulationConfig& config)
    : config_(config),
      queue_({config.threads, config.order, config.protectMemory, config.blockSize}),
      state_(queue_, config),
      view_(state_.view(0)) {}

naive::World StageFixture::emptyWorld() const {
  naive::World world;
  world.rules = config_.rules;
  world.limits = state_.limits();
  world.mode = config_.mode;
  world.master = master();
  return world;
}

void StageFixture::put(const naive::World& world) {
  Snapshot snapshot;
  snapshot.master.resize(sizeof(Master));
  std::memcpy(snapshot.master.data(), &world.master, sizeof(Master));
  snapshot.entities = world.records();
  cpu::restoreSnapshot(queue_, state_, view_, snapshot);
}

void StageFixture::begin(const naive::World& world) {
  put(world);
  TickScratch fresh;  // as logic leaves it when it orders nothing
  setScratch(fresh);
  cpu::maintain(queue_, view_, state_.neighbourhood());
  state_.forceEnergy[1].upload(state_.forceEnergy[0].download());
  state_.directionMass[1].upload(state_.directionMass[0].download());
  state_.event.upload(std::vector<uint32_t>(state_.event.size()));
  state_.threat.upload(std::vector<uint64_t>(state_.threat.size()));  // as spawn leaves it
}

std::vector<EntityRecord> StageFixture::entities(bool afterThink, bool afterIntegrate) const {
  const auto cells = state_.cells[afterIntegrate ? 1 : 0].download();
  const auto force = state_.forceEnergy[afterThink ? 1 : 0].download();
  const auto direction = state_.directionMass[afterThink ? 1 : 0].download();
  const auto cellOf = state_.cellOf.download(), birth = state_.birthTick.download(), target = state_.target.download();
  const auto motion = state_.velocityPrevious.download();
  const auto machine = state_.state.download();
  const auto push = state_.push.download();
  std::vector<EntityRecord> found;
  for (uint32_t id = 0; id < cells.size(); ++id) {
    const Cell& cell = cells[cellOf[id]];
    EXPECT_EQ(cell.id, id);
    if (cell.type == kTypeNone) continue;
    found.push_back({id,           cell.type,       cell.x,          cell.y,          motion[id].z,
                     motion[id].w, motion[id].x,    motion[id].y,    force[id].x,     force[id].y,
                     force[id].w,  direction[id].z, direction[id].x, direction[id].y, push[id].x,
                     push[id].y,   machine[id].x,   machine[id].y,   machine[id].z,   machine[id].w,
                     birth[id],    target[id]});
  }
  return found;
}

Master StageFixture::master() const {
  return onlyOne(state_.master);
}
TickScratch StageFixture::scratch() const {
  return onlyOne(state_.scratch);
}
void StageFixture::setMaster(const Master& master) {
  state_.master.upload(&master, 1);
}
void StageFixture::setScratch(const TickScratch& scratch) {
  state_.scratch.upload(&scratch, 1);
}

void StageFixture::setInput(const InputRecord& input) {
  TickScratch now = scratch();
  now.input = input;
  setScratch(now);
}

::testing::AssertionResult same(const std::vector<EntityRecord>& is, const std::vector<EntityRecord>& wanted) {
  for (size_t i = 0; i < is.size() && i < wanted.size(); ++i) {
    for (const Field& field : kEntityFields) {
      if (at<uint32_t>(&is[i], field.offset) == at<uint32_t>(&wanted[i], field.offset)) continue;
      auto failure = ::testing::AssertionFailure()
                     << "entity " << wanted[i].id << " of type " << wanted[i].type << ", " << field.name << ": ";
      if (field.isFloat)
        return failure << at<float>(&is[i], field.offset) << ", not " << at<float>(&wanted[i], field.offset);
      return failure << at<uint32_t>(&is[i], field.offset) << ", not " << at<uint32_t>(&wanted[i], field.offset);
    }
  }
  if (is.size() != wanted.size()) {
    return ::testing::AssertionFailure() << is.size() << " entities, not " << wanted.size();
  }
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult same(const Master& is, const Master& wanted) {
  for (size_t offset = 0; offset < sizeof(Master); offset += 4) {
    const uint32_t a = at<uint32_t>(&is, offset), b = at<uint32_t>(&wanted, offset);
    if (a == b) continue;
    return ::testing::AssertionFailure() << "master, byte " << offset << ": " << a << " (" << at<float>(&is, offset)
                                         << "), not " << b << " (" << at<float>(&wanted, offset) << ")";
  }
  return ::testing::AssertionSuccess();
}

}  // namespace gw::test
