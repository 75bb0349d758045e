// Governors, turbo, quotas and affinities as machines and containers have them, in a folder that stands for /.
#include "game/profile/session/processor_watch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/gpu/devices/fake_system.h"

namespace gw::profile {
namespace {

using gw::test::FakeSystem;

void processor(FakeSystem& system, uint32_t number, const std::string& governor, uint32_t least_kHz,
               uint32_t most_kHz) {
  const std::string folder = "sys/devices/system/cpu/cpu" + std::to_string(number) + "/cpufreq/";
  system.file(folder + "scaling_governor", governor + "\n")
      .file(folder + "scaling_min_freq", std::to_string(least_kHz) + "\n")
      .file(folder + "scaling_max_freq", std::to_string(most_kHz) + "\n");
}

TEST(Clocks, OfAMachineThatDoesNotSayAreUnknownAndNobodysFault) {
  const Clocks clocks = readClocks({0, 1}, FakeSystem().root());
  EXPECT_EQ(clocks.governor, "");
  EXPECT_EQ(clocks.turbo, "");
  EXPECT_EQ(clocks.range, "");
  EXPECT_TRUE(clocks.fixed);
}

TEST(Clocks, AreFixedByTheGovernorOrByTheirLimits) {
  FakeSystem system;
  processor(system, 0, "performance", 800'000, 3'400'000);
  processor(system, 1, "performance", 800'000, 3'400'000);
  processor(system, 2, "powersave", 2'400'000, 2'400'000);
  processor(system, 3, "schedutil", 600'000, 2'000'000);
  const auto of = [&](std::vector<uint32_t> processors) { return readClocks(processors, system.root()); };
  EXPECT_EQ(of({0, 1}).governor, "performance");
  EXPECT_EQ(of({0, 1}).range, "800 to 3400 MHz");
  EXPECT_TRUE(of({0, 1}).fixed);
  EXPECT_EQ(of({2}).range, "2400 MHz");
  EXPECT_TRUE(of({2}).fixed);
  EXPECT_TRUE(of({0, 2}).fixed);
  EXPECT_EQ(of({0, 2}).governor, "performance, powersave");
  EXPECT_FALSE(of({3}).fixed);
  EXPECT_FALSE(of({0, 3}).fixed);
  EXPECT_EQ(of({0, 3}).range, "600 to 3400 MHz");
}

TEST(Clocks, TurboIsSaidInThreeWays) {
  const std::string folder = "sys/devices/system/cpu/";
  const auto turbo = [](const FakeSystem& system) { return readClocks({0, 1}, system.root()).turbo; };
  for (const bool on : {false, true}) {
    FakeSystem intel, acpi, amd;
    intel.file(folder + "intel_pstate/no_turbo", on ? "0\n" : "1\n");
    acpi.file(folder + "cpufreq/boost", on ? "1\n" : "0\n");
    for (const uint32_t number : {0u, 1u}) {
      processor(amd, number, "performance", 1000, 2000);
      amd.file(folder + "cpu" + std::to_string(number) + "/cpufreq/boost", on ? "1\n" : "0\n");
    }
    for (const FakeSystem* system : {&intel, &acpi, &amd}) EXPECT_EQ(turbo(*system), on ? "on" : "off");
  }
}

// A machine whose allowed processors all have this governor: tests cannot choose their own affinity's numbers.
void everyProcessor(FakeSystem& system, const std::string& governor) {
  for (const uint32_t number : readProcessors().allowed) processor(system, number, governor, 800'000, 3'400'000);
}

void quota(FakeSystem& system, const std::string& max, const std::string& throttled_us) {
  system.file("proc/self/mountinfo", "30 23 0:26 / /sys/fs/cgroup rw - cgroup2 cgroup2 rw\n")
      .file("proc/self/cgroup", "0::/\n")
      .file("sys/devices/system/cpu/online", "0-1\n")
      .file("sys/fs/cgroup/cpu.max", max + "\n")
      .file("sys/fs/cgroup/cpu.stat", "throttled_usec " + throttled_us + "\n");
}

TEST(ProcessorWatch, OnAQuietMachineThereIsNothingToWarnOf) {
  FakeSystem system;
  everyProcessor(system, "performance");
  const ProcessorWatch watch(system.root());
  const ProcessorState state = watch.state();
  EXPECT_EQ(state.allowed, processorList(readProcessors().allowed));
  EXPECT_EQ(state.governor, "performance");
  EXPECT_EQ(state.clockRange, "800 to 3400 MHz");
  EXPECT_TRUE(std::isnan(state.quota));
  EXPECT_TRUE(std::isnan(state.throttled_s));
  EXPECT_TRUE(watch.warnings(state).empty());
}

TEST(ProcessorWatch, AGovernorThatMovesTheClocksIsWarnedOf) {
  FakeSystem system;
  everyProcessor(system, "powersave");
  const ProcessorWatch watch(system.root());
  const auto warnings = watch.warnings(watch.state());
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("powersave (800 to 3400 MHz)"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("set it to performance"), std::string::npos);
}

TEST(ProcessorWatch, AGovernorThatChangesMeanwhileIsToldAsBoth) {
  FakeSystem system;
  everyProcessor(system, "performance");
  const ProcessorWatch watch(system.root());
  everyProcessor(system, "powersave");
  EXPECT_EQ(watch.state().governor, "performance, then powersave");
  EXPECT_EQ(watch.warnings(watch.state()).size(), 1u);
}

TEST(ProcessorWatch, WhatAQuotaHeldUpMeanwhileIsToldAndWarnedOf) {
  FakeSystem system;
  quota(system, "30000 100000", "7000000");
  const ProcessorWatch watch(system.root());
  EXPECT_DOUBLE_EQ(watch.state().quota, 0.3);
  EXPECT_DOUBLE_EQ(watch.state().throttled_s, 0) << "what was before counts for nothing";
  EXPECT_TRUE(watch.warnings(watch.state()).empty());
  quota(system, "30000 100000", "12600000");
  EXPECT_NEAR(watch.state().throttled_s, 5.6, 1e-9);
  const auto warnings = watch.warnings(watch.state());
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(
      warnings[0],
      "A quota of 0.3 of 2 processors' time held threads up for 5.60 s: ask for fewer --threads, or measure without "
      "the quota.");
}

}  // namespace
}  // namespace gw::profile
