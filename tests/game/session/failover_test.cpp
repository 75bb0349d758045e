// A game whose device fails goes on with the next one: the same reports, whichever call it was that failed.
#include "game/session/failover.h"

#include <gtest/gtest.h>

#include "game/tables/tables.h"
#include "gpu/devices/device_error.h"

namespace gw {
namespace {

constexpr uint32_t kTicks = 150;

// A device on which the nth call fails, and every later one: it is a cpu device up to there.
class FailingDevice final : public ForwardingSimulation {
 public:
  FailingDevice(const SimulationConfig& config, uint64_t fails)
      : ForwardingSimulation(cpu::makeSimulation(config)), fails_(fails), facts_(device_->facts()) {
    facts_.deviceName = "failing";
    facts_.onCuda = true;
  }

  const SimulationFacts& facts() const override { return facts_; }
  void park() override {}

 private:
  Simulation& device() override {
    if (++calls_ >= fails_) throw DeviceError("the device is gone");
    return *device_;
  }

  uint64_t fails_, calls_ = 0;
  SimulationFacts facts_;
};

class FailoverTest : public testing::Test {
 protected:
  static SimulationConfig config(Autopilot autopilot) {
    SimulationConfig config;
    config.rules = loadRules(readRuleTexts(GW_ASSETS_DIR));
    config.enemies = 96;
    config.mode = Mode::swarm;
    config.threads = 1;
    config.autopilot = autopilot;
    return config;
  }

  std::unique_ptr<Failover> failing(const SimulationConfig& config, uint64_t fails) {
    return std::make_unique<Failover>(
        std::make_unique<FailingDevice>(config, fails), [config] { return cpu::makeSimulation(config); },
        [this](const std::string& why) { told.push_back(why); });
  }

  // Keys that change often, so that a lost or doubled input changes the game.
  static InputRecord keys(uint32_t tick) {
    return {int16_t(tick * 7919 % 20001 - 10000), int16_t(tick * 104729 % 20001 - 10000), uint16_t(tick * 331),
            uint16_t(tick % 3 == 0)};
  }

  static std::vector<uint64_t> play(Simulation& simulation, uint32_t inFlight) {
    std::vector<uint64_t> hashes;
    uint32_t queued = 0;
    while (hashes.size() < kTicks) {
      while (queued < kTicks && queued - hashes.size() < inFlight) simulation.tick(keys(queued++));
      const TickReport report = simulation.report();
      EXPECT_EQ(report.tick, hashes.size() + 1);
      hashes.push_back(report.hash);
    }
    return hashes;
  }

  std::vector<std::string> told;
};

TEST_F(FailoverTest, GoesOnWithTheSameBitsWhicheverCallFails) {
  for (const Autopilot autopilot : {Autopilot::none, Autopilot::expert}) {
    const SimulationConfig wanted = config(autopilot);
    for (const uint32_t inFlight : {1u, Simulation::kTicksInFlight}) {
      const std::vector<uint64_t> expected = play(*cpu::makeSimulation(wanted), inFlight);
      ASSERT_NE(expected[kTicks - 1], expected[kTicks - 2]);
      // Every call round the start and the snapshots, and some in between.
      for (uint64_t fails = 1; fails <= 2 * kTicks + 2; fails += fails % 120 < 12 || fails % 120 > 116 ? 1 : 13) {
        told.clear();
        const auto game = failing(wanted, fails);
        EXPECT_EQ(play(*game, inFlight), expected) << "call " << fails << " failed, " << inFlight << " in flight";
        EXPECT_EQ(told, std::vector<std::string>{"the device is gone"});
        EXPECT_EQ(game->dropped(), "the device is gone");
        EXPECT_FALSE(game->onCuda());
      }
    }
  }
}

TEST_F(FailoverTest, LeavesAGameAloneThatDoesNotFail) {
  const SimulationConfig wanted = config(Autopilot::expert);
  const auto game = failing(wanted, ~0ull);
  EXPECT_EQ(play(*game, 3), play(*cpu::makeSimulation(wanted), 3));
  EXPECT_TRUE(told.empty());
  EXPECT_EQ(game->dropped(), "");
  EXPECT_TRUE(game->onCuda());
}

TEST_F(FailoverTest, GoesOnFromWhatWasRestored) {
  const SimulationConfig wanted = config(Autopilot::expert);
  const auto other = cpu::makeSimulation(wanted);
  play(*other, 1);
  const Snapshot snapshot = other->snapshot();
  const auto expected = cpu::makeSimulation(wanted);
  expected->restore(snapshot);
  for (const uint64_t fails : {1u, 2u, 3u, 9u, 30u}) {
    const auto game = failing(wanted, fails);
    game->restore(snapshot);
    expected->restore(snapshot);
    for (uint32_t t = 0; t < 20; ++t) {
      game->tick(keys(t));
      expected->tick(keys(t));
      EXPECT_EQ(game->report().hash, expected->report().hash) << "call " << fails << ", tick " << t;
    }
  }
}

TEST_F(FailoverTest, ReadsReportsThatAreOwedBeforeItRestores) {
  const SimulationConfig wanted = config(Autopilot::expert);
  const auto game = failing(wanted, 4);
  const auto expected = cpu::makeSimulation(wanted);
  const Snapshot start = expected->snapshot();
  for (uint32_t t = 0; t < 3; ++t) game->tick(keys(t));
  game->restore(start);  // its reading of the reports is the fourth call
  for (uint32_t t = 0; t < 3; ++t) {
    expected->tick(keys(t));
    EXPECT_EQ(game->report().hash, expected->report().hash);
  }
  game->tick(keys(0));
  expected->restore(start);
  expected->tick(keys(0));
  EXPECT_EQ(game->report().hash, expected->report().hash);
}

TEST_F(FailoverTest, DropsADeviceThatItsUsersCannotUse) {
  const SimulationConfig wanted = config(Autopilot::expert);
  const auto game = failing(wanted, ~0ull);
  const auto expected = cpu::makeSimulation(wanted);
  for (uint32_t t = 0; t < 100; ++t) {
    if (t == 71) game->dropDevice("the screen is on another planet");
    game->tick(keys(t));
    expected->tick(keys(t));
    EXPECT_EQ(game->report().hash, expected->report().hash);
  }
  EXPECT_EQ(game->dropped(), "the screen is on another planet");
  EXPECT_THROW(game->dropDevice("again"), DeviceError);
}

TEST_F(FailoverTest, LetsADrawListFailForWhoeverDraws) {
  const SimulationConfig wanted = config(Autopilot::expert);
  const auto game = failing(wanted, 1);
  EXPECT_THROW(game->drawList({}, {}), DeviceError);
  EXPECT_TRUE(told.empty());
}

TEST_F(FailoverTest, ASimulationAloneHasNothingToFallBackOn) {
  EXPECT_THROW(cpu::makeSimulation(config(Autopilot::none))->dropDevice("gone"), DeviceError);
}

}  // namespace
}  // namespace gw
