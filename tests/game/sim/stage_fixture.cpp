#include "tests/game/sim/stage_fixture.h"

#include <cstring>

#include "game/sim/entity_copies.h"
#include "game/sim/snapshot.h"
#include "game/tables/tables.h"

namespace gw::test {
namespace {

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
  world.globals = globals();
  return world;
}

void StageFixture::put(const naive::World& world) {
  Snapshot snapshot;
  snapshot.globals.resize(sizeof(GameGlobals));
  std::memcpy(snapshot.globals.data(), &world.globals, sizeof(GameGlobals));
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
  const auto side = [](bool after) { return after ? cpu::Side::end : cpu::Side::start; };
  const cpu::EntityCopies copies(state_, view_, side(afterIntegrate), side(afterThink));
  std::vector<EntityRecord> found;
  for (uint32_t id = 0; id < view_.capacity; ++id) {
    const EntityRecord e = copies.at(id);
    EXPECT_EQ(e.id, id);
    if (e.type != kTypeNone) found.push_back(e);
  }
  return found;
}

GameGlobals StageFixture::globals() const {
  return onlyOne(state_.globals);
}
TickScratch StageFixture::scratch() const {
  return onlyOne(state_.scratch);
}
void StageFixture::setGlobals(const GameGlobals& globals) {
  state_.globals.upload(&globals, 1);
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
    for (const EntityField& field : kEntityFields) {
      const size_t offset = field.recordOffset;
      if (at<uint32_t>(&is[i], offset) == at<uint32_t>(&wanted[i], offset)) continue;
      auto failure = ::testing::AssertionFailure()
                     << "entity " << wanted[i].id << " of type " << wanted[i].type << ", " << field.column << ": ";
      if (field.isFloat) return failure << at<float>(&is[i], offset) << ", not " << at<float>(&wanted[i], offset);
      return failure << at<uint32_t>(&is[i], offset) << ", not " << at<uint32_t>(&wanted[i], offset);
    }
  }
  if (is.size() != wanted.size()) {
    return ::testing::AssertionFailure() << is.size() << " entities, not " << wanted.size();
  }
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult same(const GameGlobals& is, const GameGlobals& wanted) {
  for (size_t offset = 0; offset < sizeof(GameGlobals); offset += 4) {
    const uint32_t a = at<uint32_t>(&is, offset), b = at<uint32_t>(&wanted, offset);
    if (a == b) continue;
    return ::testing::AssertionFailure() << "globals, byte " << offset << ": " << a << " (" << at<float>(&is, offset)
                                         << "), not " << b << " (" << at<float>(&wanted, offset) << ")";
  }
  return ::testing::AssertionSuccess();
}

}  // namespace gw::test
