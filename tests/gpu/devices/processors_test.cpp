// How many processors a process may use, on machines and in containers as they are met.
#include "gpu/devices/processors.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <thread>

#include "tests/gpu/devices/fake_system.h"

namespace gw {
namespace {

using test::FakeSystem;
using List = std::vector<uint32_t>;

constexpr const char* kVersion2 = "30 23 0:26 / /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw,nsdelegate\n";
constexpr const char* kVersion1 =
    "31 23 0:28 / /sys/fs/cgroup rw - tmpfs tmpfs rw,mode=755\n"
    "32 31 0:29 / /sys/fs/cgroup/cpu,cpuacct rw - cgroup cgroup rw,cpu,cpuacct\n"
    "33 31 0:30 / /sys/fs/cgroup/cpuset rw - cgroup cgroup rw,cpuset\n"
    "41 31 0:38 / /sys/fs/cgroup/unified rw - cgroup2 cgroup2 rw\n";

TEST(ProcessorLists, AreReadAndWrittenAsLinuxDoes) {
  for (const auto& [text, list] : {std::pair<std::string, List>{"", {}},
                                   {"0", {0}},
                                   {"0-3", {0, 1, 2, 3}},
                                   {"0-1,8,10-12", {0, 1, 8, 10, 11, 12}}}) {
    EXPECT_EQ(processorsInList(text), list);
    EXPECT_EQ(processorList(list), text);
  }
  EXPECT_EQ(processorsInList("0-1\n"), (List{0, 1}));
  EXPECT_EQ(processorsInList("none"), List{});
  EXPECT_LE(processorsInList("0-4294967295").size(), size_t(1) << 16) << "a damaged list costs no memory";
}

TEST(Processors, TheLeastOfThreeIsUsable) {
  EXPECT_EQ((Processors{8, {}, {}}.usable()), 8u);
  EXPECT_EQ((Processors{8, {0, 1, 5}, {}}.usable()), 3u);
  EXPECT_EQ((Processors{8, {0, 1, 5}, 1.5}.usable()), 2u) << "a begun processor counts";
  EXPECT_EQ((Processors{8, {0, 1, 5}, 2.0}.usable()), 2u);
  EXPECT_EQ((Processors{8, {0, 1, 5}, 64.0}.usable()), 3u);
  EXPECT_EQ((Processors{8, {}, 0.01}.usable()), 1u);
  EXPECT_EQ((Processors{2, {0, 1, 2, 3}, {}}.usable()), 2u);
  EXPECT_EQ((Processors{0, {}, {}}.usable()), 1u);
}

TEST(Processors, LimitsAreSaid) {
  EXPECT_EQ((Processors{8, {}, {}}.limits()), "");
  EXPECT_EQ((Processors{2, {0, 1}, 2.0}.limits()), "");
  EXPECT_EQ((Processors{8, {0, 1, 5}, {}}.limits()), "an affinity to 3 of 8 processors");
  EXPECT_EQ((Processors{8, {}, 1.5}.limits()), "a quota of 1.5 of 8 processors");
  EXPECT_EQ((Processors{1, {0}, 0.25}.limits()), "a quota of 0.25 of 1 processor");
  EXPECT_EQ((Processors{8, {0}, 4.0}.limits()), "an affinity to 1 of 8 processors, a quota of 4 of 8 processors");
}

TEST(Processors, ThoseThatAreOnlineAreCounted) {
  FakeSystem system;
  system.file("sys/devices/system/cpu/online", "0-5,8\n");
  const Processors processors = readProcessors(system.root());
  EXPECT_EQ(processors.present, 7u);
  EXPECT_FALSE(processors.quota.has_value());
  EXPECT_GE(readProcessors(FakeSystem().root()).present, 1u) << "without the file the system is asked";
}

TEST(Processors, TheAffinityIsThatOfTheThread) {
  const List all = readProcessors().allowed;
  ASSERT_FALSE(all.empty());
  std::thread([&] {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(all.back(), &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    EXPECT_EQ(readProcessors().allowed, List{all.back()});
    EXPECT_EQ(readProcessors().usable(), 1u);
  }).join();
  EXPECT_EQ(readProcessors().allowed, all);
}

// ---------------------------------------------------------------- quotas

TEST(ProcessorQuota, OfVersion2IsFoundAlongTheWholePath) {
  FakeSystem system;
  system.file("proc/self/mountinfo", kVersion2).file("proc/self/cgroup", "0::/user.slice/app.scope\n");
  const auto quota = [&] { return ProcessorQuota(system.root()).processors(); };
  EXPECT_EQ(quota(), std::nullopt) << "no file says anything";
  system.file("sys/fs/cgroup/user.slice/app.scope/cpu.max", "max 100000\n");
  EXPECT_EQ(quota(), std::nullopt);
  system.file("sys/fs/cgroup/user.slice/app.scope/cpu.max", "250000 100000\n");
  EXPECT_DOUBLE_EQ(quota().value(), 2.5);
  system.file("sys/fs/cgroup/user.slice/cpu.max", "50000 100000\n");
  EXPECT_DOUBLE_EQ(quota().value(), 0.5) << "the group above has less";
  system.file("sys/fs/cgroup/user.slice/cpu.max", "800000 100000\n");
  EXPECT_DOUBLE_EQ(quota().value(), 2.5);
  system.file("sys/fs/cgroup/other.slice/cpu.max", "10000 100000\n");
  EXPECT_DOUBLE_EQ(quota().value(), 2.5) << "other groups' quotas are theirs";
}

TEST(ProcessorQuota, OfVersion1IsFoundInTheProcessorsHierarchy) {
  FakeSystem system;
  system.file("proc/self/mountinfo", kVersion1)
      .file("proc/self/cgroup", "3:cpuset:/elsewhere\n1:cpu,cpuacct:/jobs/one\n0::/jobs\n")
      .file("sys/fs/cgroup/cpu,cpuacct/jobs/one/cpu.cfs_quota_us", "-1\n")
      .file("sys/fs/cgroup/cpu,cpuacct/jobs/one/cpu.cfs_period_us", "100000\n");
  const auto quota = [&] { return ProcessorQuota(system.root()).processors(); };
  EXPECT_EQ(quota(), std::nullopt);
  system.file("sys/fs/cgroup/cpu,cpuacct/jobs/one/cpu.cfs_quota_us", "30000\n");
  EXPECT_DOUBLE_EQ(quota().value(), 0.3);
  system.file("sys/fs/cgroup/cpu,cpuacct/jobs/cpu.cfs_quota_us", "20000\n")
      .file("sys/fs/cgroup/cpu,cpuacct/jobs/cpu.cfs_period_us", "50000\n");
  EXPECT_DOUBLE_EQ(quota().value(), 0.3) << "0.4 above is more";
  system.file("sys/fs/cgroup/cpuset/elsewhere/cpu.cfs_quota_us", "1000\n")
      .file("sys/fs/cgroup/cpuset/elsewhere/cpu.cfs_period_us", "100000\n");
  EXPECT_DOUBLE_EQ(quota().value(), 0.3) << "other hierarchies share out other things";
}

// A container's own group is mounted where the whole tree is elsewhere, under the name that it has outside...
TEST(ProcessorQuota, OfAContainerIsAtItsMount) {
  FakeSystem system;
  system.file("proc/self/mountinfo", "9 8 0:29 /docker/12ab /sys/fs/cgroup/cpu ro - cgroup cgroup rw,cpu\n")
      .file("proc/self/cgroup", "4:cpu:/docker/12ab/inner\n")
      .file("sys/fs/cgroup/cpu/cpu.cfs_quota_us", "150000\n")
      .file("sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n");
  const auto quota = [&] { return ProcessorQuota(system.root()).processors(); };
  EXPECT_DOUBLE_EQ(quota().value(), 1.5);
  system.file("sys/fs/cgroup/cpu/inner/cpu.cfs_quota_us", "50000\n")
      .file("sys/fs/cgroup/cpu/inner/cpu.cfs_period_us", "100000\n");
  EXPECT_DOUBLE_EQ(quota().value(), 0.5);
}

// ... or under none, or a name that leads out of what can be seen here.
TEST(ProcessorQuota, OfANamespaceIsAtItsMountToo) {
  for (const char* path : {"/", "/../elsewhere", "/../../a/b"}) {
    FakeSystem system;
    system.file("proc/self/mountinfo", kVersion2)
        .file("proc/self/cgroup", std::string("0::") + path + "\n")
        .file("sys/fs/cgroup/cpu.max", "75000 50000\n");
    EXPECT_DOUBLE_EQ(ProcessorQuota(system.root()).processors().value(), 1.5) << path;
  }
}

TEST(ProcessorQuota, MountPointsMayHoldSpaces) {
  FakeSystem system;
  system.file("proc/self/mountinfo", "30 23 0:26 / /run/my\\040groups rw - cgroup2 none rw\n")
      .file("proc/self/cgroup", "0::/a b\n")
      .file("run/my groups/a b/cpu.max", "100000 100000\n");
  EXPECT_DOUBLE_EQ(ProcessorQuota(system.root()).processors().value(), 1);
}

TEST(ProcessorQuota, OddFilesAreNoLimit) {
  for (const char* text : {"", "max", "-1", "0 0", "100000", "100000 0", "words words", "-5 100000"}) {
    FakeSystem system;
    system.file("proc/self/mountinfo", kVersion2)
        .file("proc/self/cgroup", "nonsense\n:\n::\n0::/\n")
        .file("sys/fs/cgroup/cpu.max", text);
    EXPECT_EQ(ProcessorQuota(system.root()).processors(), std::nullopt) << text;
  }
  EXPECT_EQ(ProcessorQuota(FakeSystem().root()).processors(), std::nullopt) << "no /proc at all";
}

TEST(ProcessorQuota, WaitingIsThatOfTheGroupThatWaitedLongest) {
  FakeSystem system;
  system.file("proc/self/mountinfo", kVersion2).file("proc/self/cgroup", "0::/a/b\n");
  system.file("sys/fs/cgroup/a/b/cpu.stat", "usage_usec 5\nnr_throttled 3\nthrottled_usec 1500000\n");
  EXPECT_EQ(ProcessorQuota(system.root()).throttled_s(), std::nullopt) << "nothing can throttle without a quota";
  system.file("sys/fs/cgroup/a/cpu.max", "30000 100000\n");
  EXPECT_DOUBLE_EQ(ProcessorQuota(system.root()).throttled_s().value(), 1.5);
  system.file("sys/fs/cgroup/a/cpu.stat", "usage_usec 5\nthrottled_usec 4000000\n");
  EXPECT_DOUBLE_EQ(ProcessorQuota(system.root()).throttled_s().value(), 4);

  FakeSystem old;
  old.file("proc/self/mountinfo", kVersion1)
      .file("proc/self/cgroup", "1:cpu,cpuacct:/\n")
      .file("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "30000\n")
      .file("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_period_us", "100000\n")
      .file("sys/fs/cgroup/cpu,cpuacct/cpu.stat", "nr_periods 9\nnr_throttled 4\nthrottled_time 5600000000\n");
  EXPECT_DOUBLE_EQ(ProcessorQuota(old.root()).throttled_s().value(), 5.6);
}

}  // namespace
}  // namespace gw
