#include "tests/ptx_machine/runtime/machine_options.h"

#include <gtest/gtest.h>

namespace gw::ptx {
namespace {

TEST(MachineOptions, TakesEachOption) {
  MachineOptions options;
  for (const char* option :
       {"engine=interpreter", "order=shuffled", "seed=18446744073709551615", "races=off", "stop-at-fault"}) {
    EXPECT_TRUE(takeMachineOption(options, option)) << option;
  }
  EXPECT_EQ(options.engine, Engine::interpreter);
  EXPECT_EQ(options.machine.order, Order::shuffled);
  EXPECT_EQ(options.machine.seed, ~uint64_t(0));
  EXPECT_TRUE(options.machine.checkAccesses);
  EXPECT_FALSE(options.machine.checkRaces);
  EXPECT_TRUE(options.stopAtFault);
  EXPECT_TRUE(takeMachineOption(options, "unchecked"));
  EXPECT_FALSE(options.machine.checkAccesses);
  for (const auto& [option, order] :
       {std::pair{"order=reversed", Order::reversed}, {"order=ascending", Order::ascending}}) {
    EXPECT_TRUE(takeMachineOption(options, option));
    EXPECT_EQ(options.machine.order, order);
  }
  EXPECT_TRUE(takeMachineOption(options, "engine=translated"));
  EXPECT_EQ(options.engine, Engine::translated);
}

TEST(MachineOptions, RefusesWhatItDoesNotKnow) {
  MachineOptions options;
  for (const char* option :
       {"", "engine", "engine=", "engine=fast", "order=random", "seed=", "seed=-1", "seed=1x",
        "seed=18446744073709551616", "races=on", "races", "unchecked=1", "reversed", "stop-at-faults", " unchecked"}) {
    EXPECT_FALSE(takeMachineOption(options, option)) << option;
  }
}

}  // namespace
}  // namespace gw::ptx
