// The recorder: what it writes at the end, and what it leaves of a run that had none.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <optional>

#include "game/replay/recorder.h"
#include "game/replay/replay_reader.h"
#include "host/platform/part_file.h"
#include "tests/game/replay/replay_allocation_watch.h"
#include "tests/game/replay/replay_samples.h"

namespace gw::test {
namespace {

namespace fs = std::filesystem;

class ReplayRecorder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "gw_recorder_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  size_t filesThere() const { return size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }
  Recorder recorder(const fs::path& name = "run.gwr") const {
    return {folder_ / name, longerReplay().header, longerReplay().rules};
  }
  fs::path target() const { return folder_ / "run.gwr"; }

  static std::string refusal(auto action) {
    try {
      action();
      return "";
    } catch (const FileError& error) {
      return error.what();
    }
  }
  static bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }
  static void record(Recorder& recording, size_t ticks) {
    const Replay run = longerReplay();
    for (size_t i = 0; i < ticks; ++i) ASSERT_TRUE(recording.append(reportOf(run, i % run.inputs.size())));
  }
  // The only file beside the target.
  Replay leftOver() const {
    const auto parts = partsLeftBeside(target());
    if (parts.size() != 1) throw std::runtime_error("there are " + std::to_string(parts.size()) + " parts");
    return readReplay(parts[0], SimulationVersions::current, Completeness::partial);
  }
  // Runs in a child process that ends as it likes; how it ended.
  static int inChild(auto action) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      std::freopen("/dev/null", "w", stderr);
      action();
      _exit(0);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return status;
  }

  fs::path folder_;
};

TEST_F(ReplayRecorder, WritesWhatItWasGiven) {
  const Replay run = longerReplay();
  Recorder recording = recorder();
  EXPECT_EQ(filesThere(), 1u);  // the growing file
  EXPECT_FALSE(fs::exists(target()));
  record(recording, run.inputs.size());
  EXPECT_EQ(recording.ticks(), 150u);
  recording.finish(run.result);
  EXPECT_EQ(filesThere(), 1u);
  EXPECT_TRUE(sameContent(readReplay(target()), run));
  EXPECT_THROW(recording.finish(run.result), std::logic_error);
}

TEST_F(ReplayRecorder, RefusesBadPathsAtOnce) {
  EXPECT_TRUE(contains(refusal([&] { recorder("none/run.gwr"); }), "cannot be written"));
}

TEST_F(ReplayRecorder, LeavesNothingWhenAbandoned) {
  {
    Recorder recording = recorder();
    record(recording, 70);
    recording.abandon();
    EXPECT_FALSE(recording.append({}));
    EXPECT_THROW(recording.finish({}), std::logic_error);
  }
  EXPECT_EQ(filesThere(), 0u);
}

TEST_F(ReplayRecorder, WritesNothingWithoutATick) {
  EXPECT_TRUE(contains(refusal([&] { recorder().finish({}); }), "not a single tick"));
  EXPECT_EQ(filesThere(), 0u);
  { recorder(); }
  EXPECT_EQ(filesThere(), 0u);
}

TEST_F(ReplayRecorder, StopsAtFourHours) {
  Recorder recording = recorder();
  TickReport report;
  for (uint32_t i = 0; i < kMaxTicks; ++i) {
    report.hash = i;
    ASSERT_TRUE(recording.append(report));
  }
  EXPECT_FALSE(recording.append(report));
  EXPECT_LT(fs::file_size(fs::directory_iterator(folder_)->path()), replay_format::kMaxFileBytes);
  recording.finish({});
  EXPECT_EQ(readReplay(target()).ticks(), kMaxTicks);
}

TEST_F(ReplayRecorder, CutsLongOptionTexts) {
  ReplayHeader header = longerReplay().header;
  header.options.assign(100'000, 'x');
  Recorder recording(target(), header, longerReplay().rules);
  record(recording, 1);
  recording.finish({});
  EXPECT_EQ(readReplay(target()).header.options.size(), replay_format::kMaxOptionsBytes);
}

TEST_F(ReplayRecorder, AppendsWithoutAllocating) {
  Recorder recording = recorder();
  const Replay run = longerReplay();
  std::vector<TickReport> reports;
  for (size_t i = 0; i < run.inputs.size(); ++i) reports.push_back(reportOf(run, i));
  watchAllocations();
  for (int round = 0; round < 20; ++round) {
    for (TickReport& report : reports) {
      report.input.aim = uint16_t(report.input.aim + 1);  // no two equal: the longest that a block can be
      report.input.move_x = int16_t(report.tick);
      recording.append(report);
    }
  }
  EXPECT_EQ(allocations(), 0u);
  EXPECT_EQ(recording.ticks(), 3000u);
}

TEST_F(ReplayRecorder, AnErrorThatEndsTheRunLeavesAllItsTicks) {
  {
    Recorder recording = recorder();
    record(recording, 130);
  }
  EXPECT_FALSE(fs::exists(target()));
  const Replay left = leftOver();
  EXPECT_FALSE(left.whole);
  EXPECT_EQ(left.ticks(), 130u);
  EXPECT_EQ(left.fieldHashes.size(), 2u);
  EXPECT_EQ(left.header, longerReplay().header);
  Replay run = longerReplay();
  run.inputs.resize(130);
  EXPECT_EQ(left.inputs, run.inputs);
}

TEST_F(ReplayRecorder, AKilledProgramLeavesEverySecond) {
  for (const int how : {SIGKILL, SIGABRT}) {
    const int status = inChild([&] {
      Recorder recording = recorder();
      record(recording, 149);
      if (how == SIGABRT) std::terminate();
      raise(how);
    });
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), how);
    const Replay left = leftOver();
    EXPECT_EQ(left.ticks(), 120u);
    EXPECT_FALSE(left.whole);
    fs::remove(partsLeftBeside(target())[0]);
  }
}

TEST_F(ReplayRecorder, LeavesOthersPartsAlone) {
  {
    auto killed = recorder();
    record(killed, 60);
  }
  const fs::path left = partsLeftBeside(target()).at(0);
  const auto length = fs::file_size(left);
  {
    Recorder second = recorder();
    EXPECT_EQ(partsLeftBeside(target()), std::vector{left}) << "a file that is being written is not left over";
    record(second, 150);
    second.finish(longerReplay().result);
  }
  EXPECT_EQ(partsLeftBeside(target()), std::vector{left});
  EXPECT_EQ(fs::file_size(left), length);
  EXPECT_EQ(readReplay(target()).ticks(), 150u);
  EXPECT_TRUE(partsLeftBeside(folder_ / "other.gwr").empty());
}

// A disk that is full, by way of a limit on file sizes; for as long as this lives.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(ReplayRecorder, AFullDiskEndsNoRunAndIsSaidAtItsEnd) {
  std::string said;
  {
    Recorder recording = recorder();
    record(recording, 60);
    const auto length = [this] { return fs::file_size(fs::directory_iterator(folder_)->path()); };
    const auto before = length();
    const FullDisk full(before + 500);  // half a block more
    record(recording, 90);
    EXPECT_EQ(recording.ticks(), 150u);
    EXPECT_EQ(length(), before) << "what did not fit was taken back";
    const FullDisk fuller(100);
    said = refusal([&] { recording.finish(longerReplay().result); });
  }
  EXPECT_TRUE(contains(said, "run.gwr cannot be written: File too large; make room")) << said;
  EXPECT_TRUE(contains(said, "its first 60 ticks are in ")) << said;
  EXPECT_TRUE(contains(said, "'gpuwars trim' makes whole")) << said;
  EXPECT_EQ(leftOver().ticks(), 60u);
  EXPECT_EQ(filesThere(), 1u);
}

TEST_F(ReplayRecorder, GoesOnWhenTheDiskHasRoomAgain) {
  {
    Recorder recording = recorder();
    {
      const FullDisk full(1);
      record(recording, 600);
    }
    record(recording, 150);
    record(recording, 150);
    record(recording, 150);
    record(recording, 150);  // 1,200 in all; two blocks a second catch up
  }
  EXPECT_EQ(leftOver().ticks(), 1200u);
}

}  // namespace
}  // namespace gw::test
