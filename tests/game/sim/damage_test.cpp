// Damage to a device's memory, bit by bit: what is state is told by the hash of the very tick, whatever the bit; what
// is not state can be damaged between ticks and no hash ever differs. Which is which stands in state_bytes.cu.
#include <gtest/gtest.h>

#include <map>

#include "game/sim/debug/inspection.h"
#include "tests/game/sim/game_runs.h"

namespace gw::test {
namespace {

constexpr uint32_t kTicks = 24, kFlips = 1000;

// A short run in a crowd that shoots, with a snapshot before each tick and the hash after it.
class Damage : public testing::Test {
 protected:
  explicit Damage(SimulationConfig config = stageConfig()) : config_(std::move(config)) {
    config_.threads = 1;
    simulation_ = cpu::makeSimulation(config_);
    simulation_->restore(crowdScene(config_, 150));
    for (uint32_t t = 0; t < kTicks; ++t) {
      before_.push_back(simulation_->snapshot());
      hashes_.push_back(simulation_->inspection().tickByStages(input(t), [](const std::string&) {}).hash);
    }
  }

  // Round and round, and always shooting, so that there are births and deaths in every tick.
  static InputRecord input(uint32_t t) { return {kStickFull, 0, uint16_t(t * 3000), kButtonFire}; }

  Inspection& inspection() { return simulation_->inspection(); }

  SimulationConfig config_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<Snapshot> before_;
  std::vector<uint64_t> hashes_;
};

bool isHashed(const BytesOfBuffer& part) {
  return part.standing == Standing::hashed || part.standing == Standing::ofLiving;
}

// An element of the part that the hash looks at.
uint32_t aLivingElement(const BytesOfBuffer& part, const StageState& state, Dice& dice) {
  for (;;) {
    const uint32_t element = dice.below(part.elements);
    if (part.standing == Standing::hashed || state.entities[0].values->at(element) != kTypeNone) return element;
  }
}

TEST_F(Damage, of_state_is_told_by_the_hash_of_the_tick) {
  Dice dice(1);
  std::map<std::string, uint32_t> tried;
  uint32_t caught = 0;
  for (uint32_t flip = 0; flip < kFlips; ++flip) {
    const uint32_t t = flip % kTicks;  // the last one too
    simulation_->restore(before_[t]);
    BytesOfBuffer damaged;
    uint32_t element = 0, bit = 0;
    const TickReport report = inspection().tickByStages(input(t), [&](const std::string& stage) {
      if (stage != "settle") return;  // the last one before the hash
      std::vector<BytesOfBuffer> parts = inspection().bytes();
      std::erase_if(parts, [](const BytesOfBuffer& part) { return !isHashed(part); });
      damaged = parts[flip % parts.size()];
      element = aLivingElement(damaged, inspection().stateAfter(stage, nullptr), dice);
      bit = dice.below(8 * damaged.bytes);
      inspection().flip(damaged, element, bit);
    });
    if (damaged.buffer == "tables") inspection().flip(damaged, element, bit);  // no snapshot brings them back
    ++tried[damaged.buffer];
    EXPECT_NE(report.hash, hashes_[t]) << damaged.buffer << " " << damaged.part << " of " << element << ", bit " << bit
                                       << ", tick " << t + 1;
    caught += report.hash != hashes_[t];
    if (t > 0) {
      simulation_->restore(before_[t - 1]);  // and no trace of it in another tick
      EXPECT_EQ(inspection().tickByStages(input(t - 1), [](const std::string&) {}).hash, hashes_[t - 1]);
    }
  }
  std::printf("%u of %u flipped bits told by the hash of the tick, in %zu buffers\n", caught, kFlips, tried.size());
  EXPECT_GE(tried.size(), 12u);
}

TEST_F(Damage, of_what_is_no_state_changes_nothing) {
  Dice dice(2);
  std::map<std::string, uint32_t> tried;
  constexpr uint32_t kGoOn = 4, kPerPart = 24;
  const size_t parts = inspection().bytes().size();
  for (size_t p = 0; p < parts; ++p) {
    for (uint32_t n = 0; n < kPerPart; ++n) {
      const uint32_t t = dice.below(kTicks - kGoOn);
      simulation_->restore(before_[t]);
      StageState left;
      ASSERT_EQ(inspection()
                    .tickByStages(input(t),
                                  [&](const std::string& stage) {
                                    if (stage == "hash") left = inspection().stateAfter(stage, nullptr);
                                  })
                    .hash,
                hashes_[t]);
      const BytesOfBuffer part = inspection().bytes()[p];
      if (part.standing == Standing::hashed) break;
      const uint32_t element = dice.below(part.elements), bit = dice.below(8 * part.bytes);
      if (part.standing == Standing::ofLiving && left.entities[0].values->at(element) != kTypeNone) continue;
      inspection().flip(part, element, bit);
      ++tried[part.buffer.starts_with("derived") ? "derived" : part.buffer];
      for (uint32_t on = t + 1; on <= t + kGoOn; ++on) {
        simulation_->tick(input(on));
        ASSERT_EQ(simulation_->report().hash, hashes_[on])
            << part.buffer << " " << part.part << " of " << element << ", bit " << bit << ", after tick " << t + 1
            << ": said to be harmless since " << part.why;
      }
    }
  }
  uint32_t all = 0;
  for (const auto& [buffer, count] : tried) all += count;
  std::printf("%u flipped bits changed nothing, in %zu buffers\n", all, tried.size());
  EXPECT_GE(tried.size(), 16u);
}

class DamageInGrid : public Damage {
 protected:
  DamageInGrid()
      : Damage([] {
          SimulationConfig config = stageConfig();
          config.broadPhase = BroadPhase::grid;
          return config;
        }()) {}
};

TEST_F(DamageInGrid, of_its_bins_changes_nothing) {
  Dice dice(3);
  uint32_t tried = 0;
  for (uint32_t n = 0; n < 400; ++n) {
    const uint32_t t = n % (kTicks - 1);
    simulation_->restore(before_[t]);
    inspection().tickByStages(input(t), [](const std::string&) {});
    const std::vector<BytesOfBuffer> parts = inspection().bytes();
    const BytesOfBuffer& part = parts[parts.size() - 1 - n % 12];
    if (part.standing != Standing::costOnly) continue;
    const uint32_t element = dice.below(part.elements), bit = dice.below(8);
    inspection().flip(part, element, bit);
    ++tried;
    simulation_->tick(input(t + 1));
    ASSERT_EQ(simulation_->report().hash, hashes_[t + 1]) << part.buffer << ", byte " << element << ", bit " << bit;
  }
  EXPECT_GT(tried, 100u);
}

// The list is whole: no two parts share a byte, and those of a buffer leave none out.
TEST_F(Damage, every_byte_stands_in_the_list_once) {
  std::map<const uint8_t*, uint32_t> begins;
  for (const BytesOfBuffer& part : inspection().bytes()) {
    EXPECT_GT(part.elements, 0u) << part.buffer;
    EXPECT_TRUE(begins.emplace(part.d_bytes, part.bytes).second) << part.buffer << " " << part.part;
    EXPECT_EQ(part.why.empty(), isHashed(part)) << part.buffer << " " << part.part;
  }
  const uint8_t* end = nullptr;
  for (const auto& [begin, bytes] : begins) {
    EXPECT_GE(begin, end);
    end = begin + bytes;
  }
}

}  // namespace
}  // namespace gw::test
