// One stage at a time: a game's state on the cpu device into which a test puts entities by hand, runs one
// stage, and looks at what it left.
//
// A stage reads what earlier ones of the same tick have written. begin() stands for all of them: the
// entities lie sorted in `cells`, and force and direction stand in both their halves, as if think had
// wished for nothing.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "game/sim/entity_flags.h"
#include "game/sim/stages.h"
#include "tests/reference/sim_world.h"

namespace gw::test {

// The rules of assets/, read once.
const Rules& gameRules();

// The game's rules for this many enemies, one thread: what a stage needs.
SimulationConfig stageConfig(uint32_t enemies = 256);

class StageFixture {
 public:
  explicit StageFixture(const SimulationConfig& config = stageConfig());

  // The world as the naive versions see it, empty, at the start of a game.
  naive::World emptyWorld() const;

  // Puts the world's entities and globals on the device, at the start of a tick.
  void put(const naive::World& world);
  // The same, and what maintain and an idle think would leave.
  void begin(const naive::World& world);

  // What the stages have left so far: from `moved` and the back of force and direction once integrate has
  // run, else from `cells`, with forces from the side asked for. Dead cells are left out.
  std::vector<EntityRecord> entities(bool afterThink, bool afterIntegrate) const;

  GameGlobals globals() const;
  TickScratch scratch() const;
  void setGlobals(const GameGlobals& globals);
  void setScratch(const TickScratch& scratch);
  void setInput(const InputRecord& input);  // as autopilot would leave it
  std::vector<uint32_t> events() const { return state_.event.download(); }

  cpu::Queue& queue() { return queue_; }
  cpu::GameState& state() { return state_; }
  const cpu::View& view() const { return view_; }
  const Limits& limits() const { return state_.limits(); }
  const Rules& rules() const { return config_.rules; }

 private:
  SimulationConfig config_;
  cpu::Queue queue_;
  cpu::GameState state_;
  cpu::View view_;
};

// Byte by byte, naming the first entity and field that differ.
::testing::AssertionResult same(const std::vector<EntityRecord>& is, const std::vector<EntityRecord>& wanted);
::testing::AssertionResult same(const GameGlobals& is, const GameGlobals& wanted);

}  // namespace gw::test
