// frames.csv: every frame reads back, and nothing of it is there unless all is.
#include "game/profile/report/frames_csv.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <sstream>

#include "host/platform/atomic_file.h"
#include "tests/game/profile/report/scratch_folder.h"

namespace gw::profile::test {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// As RFC 4180 has it.
Rows parsed(const std::string& text) {
  Rows rows(1, {""});
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    std::string& cell = rows.back().back();
    if (quoted) {
      if (text[i] != '"') {
        cell += text[i];
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        cell += text[++i];
      } else {
        quoted = false;
      }
    } else if (text[i] == '"') {
      quoted = true;
    } else if (text[i] == ',') {
      rows.back().emplace_back();
    } else if (text[i] == '\n') {
      rows.push_back({""});
    } else {
      cell += text[i];
    }
  }
  EXPECT_EQ(rows.back(), std::vector<std::string>{""}) << "the last row ends";
  rows.pop_back();
  return rows;
}

Frame someFrame(uint32_t at) {
  Frame frame;
  frame.tick = 120 + at;
  frame.ticks = at % 6;
  frame.simulation_ms = 1.23456 + at;
  frame.draw_ms = 0.00004;
  frame.wait_ms = 0.00006;
  frame.total_ms = 16.66666;
  frame.live = 8190;
  frame.kills = 12'345'678'901;
  return frame;
}

class CsvOfFrames : public ScratchFolder {
 protected:
  std::filesystem::path path() const { return folder_ / "frames.csv"; }
};

TEST_F(CsvOfFrames, ReadsBackCellByCell) {
  FramesCsv csv(path(), {"logic", "think", "odd, \"stage\""});
  csv.begin(8192, "ngrid", 0, {});
  csv.add(someFrame(0));
  csv.begin(1024, "a \"b\", c", 3, std::vector<std::string>{"think", "logic"});
  Frame staged = someFrame(1);
  staged.warmUp = staged.staged = true;
  staged.stages_ms = {2.5f, 0.125f};
  staged.gl_ms = 3;
  staged.latency_ms = -0.5;
  staged.candidates = 1'000'000;
  staged.neighbours = 5.25;
  staged.searching = 7;
  staged.gather_ms = 1e15;
  csv.add(staged);
  staged.staged = false;
  csv.add(staged);
  csv.finish();

  const Rows rows = parsed(content(path()));
  const std::vector<std::string> header = {"enemies",    "contender",
                                           "run",        "frame",
                                           "tick",       "warm_up",
                                           "ticks",      "simulation_ms",
                                           "draw_ms",    "wait_ms",
                                           "total_ms",   "gl_ms",
                                           "latency_ms", "live",
                                           "kills",      "candidates",
                                           "neighbours", "searching",
                                           "gather_ms",  "logic_ms",
                                           "think_ms",   "odd, \"stage\"_ms"};
  const std::vector<std::string> plain = {"8192",   "ngrid",  "0",       "0", "120", "0",    "0",           "1.2346",
                                          "0.0000", "0.0001", "16.6667", "",  "",    "8190", "12345678901", "",
                                          "",       "",       "",        "",  "",    ""};
  const std::vector<std::string> whole = {"1024",
                                          "a \"b\", c",
                                          "3",
                                          "0",
                                          "121",
                                          "1",
                                          "1",
                                          "2.2346",
                                          "0.0000",
                                          "0.0001",
                                          "16.6667",
                                          "3.0000",
                                          "-0.5000",
                                          "8190",
                                          "12345678901",
                                          "1000000",
                                          "5.2500",
                                          "7",
                                          "1000000000000000.0000",
                                          "0.1250",
                                          "2.5000",
                                          ""};
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0], header);
  EXPECT_EQ(rows[1], plain);
  EXPECT_EQ(rows[2], whole);
  EXPECT_EQ(rows[3][3], "1") << "frames of a run are counted";
  EXPECT_EQ(rows[3][19], "") << "a tick that was not staged";
}

TEST_F(CsvOfFrames, IsThereOnceItIsWhole) {
  {
    FramesCsv csv(path(), {});
    csv.begin(1, "ngrid", 0, {});
    csv.add(someFrame(0));
    EXPECT_FALSE(exists(path()));
    EXPECT_EQ(filesThere(), 1u) << "the part, which a program that is killed leaves";
    csv.finish();
    EXPECT_TRUE(exists(path()));
  }
  EXPECT_EQ(filesThere(), 1u);
}

TEST_F(CsvOfFrames, OneThatIsNotFinishedLeavesNothing) {
  put(path(), "an earlier one");
  {
    FramesCsv csv(path(), {});
    csv.begin(1, "ngrid", 0, {});
    csv.add(someFrame(0));
  }
  EXPECT_EQ(content(path()), "an earlier one");
  EXPECT_EQ(filesThere(), 1u);
}

TEST_F(CsvOfFrames, AStageWithoutAColumnIsAProgrammersError) {
  FramesCsv csv(path(), {"logic"});
  EXPECT_THROW(csv.begin(1, "ngrid", 0, std::vector<std::string>{"think"}), std::invalid_argument);
}

TEST_F(CsvOfFrames, AFullDiskIsSaidInASentence) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small = {3 << 20, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  std::string said;
  {
    FramesCsv csv(path(), {});
    csv.begin(1, "ngrid", 0, {});
    said = refusal<FileError>([&] {
      for (uint32_t i = 0; i < 100'000; ++i) csv.add(someFrame(i));
    });
  }
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(said, path().string() +
                      " cannot be written: the disk takes no more; make room or choose a folder on another disk");
  EXPECT_EQ(filesThere(), 0u);
}

TEST_F(CsvOfFrames, FoldersThatTakeNothingAreRefusedAtOnce) {
  EXPECT_NE(refusal<FileError>([&] { FramesCsv(folder_ / "none" / "frames.csv", {}); }).find("cannot be written"),
            std::string::npos);
  EXPECT_NE(refusal<FileError>([&] { FramesCsv("/dev/full", {}); }).find("not a plain file"), std::string::npos);
}

TEST_F(CsvOfFrames, OfAnHourTakesSeconds) {
  const std::vector<std::string> stages = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j"};
  Frame frame = someFrame(3);
  frame.staged = true;
  frame.stages_ms.assign(10, 0.125f);
  const auto start = std::chrono::steady_clock::now();
  FramesCsv csv(path(), stages);
  csv.begin(8192, "ngrid", 0, stages);
  for (uint32_t i = 0; i < 216'000; ++i) csv.add(frame);
  csv.finish();
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("rows_per_second", std::to_string(216'000 / took_s));
  EXPECT_LT(took_s, 30) << "a hundred times what it takes";
}

}  // namespace
}  // namespace gw::profile::test
