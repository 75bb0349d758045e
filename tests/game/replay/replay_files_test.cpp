// Replays on disk: written whole or not at all, and refused early where they cannot be written.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"
#include "tests/game/replay/replay_samples.h"

namespace gw::test {
namespace {

namespace fs = std::filesystem;

// Root may write everywhere; for as long as this lives the program runs as an unprivileged user.
class WithoutPrivileges {
 public:
  WithoutPrivileges() : wasRoot_(geteuid() == 0), dropped_(!wasRoot_ || seteuid(65534) == 0) {}
  ~WithoutPrivileges() {
    if (wasRoot_ && dropped_ && seteuid(0) != 0) std::abort();
  }
  bool dropped() const { return dropped_; }

 private:
  bool wasRoot_, dropped_;
};

class ReplayFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "gw_replay_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    chmod(folder_.c_str(), 0755);
    fs::remove_all(folder_);
  }

  size_t filesThere() const { return size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }

  static std::string refusal(auto action) {
    try {
      action();
      return "";
    } catch (const FileError& error) {
      return error.what();
    }
  }
  static std::string writing(const fs::path& path) {
    return refusal([&] { writeReplay(path, sampleReplay()); });
  }
  static std::string reading(const fs::path& path) {
    return refusal([&] { readReplay(path); });
  }
  static bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }
  fs::path folder_;
};

TEST_F(ReplayFiles, AreWrittenAndRead) {
  writeReplay(folder_ / "a.gwr", sampleReplay());
  EXPECT_EQ(readReplay(folder_ / "a.gwr").hashes, sampleReplay().hashes);
  EXPECT_EQ(filesThere(), 1u);
}

TEST_F(ReplayFiles, ReplaceOlderOnes) {
  std::ofstream(folder_ / "a.gwr") << "older";
  writeReplay(folder_ / "a.gwr", sampleReplay());
  EXPECT_EQ(reading(folder_ / "a.gwr"), "");
}

TEST_F(ReplayFiles, GoThroughLinks) {
  writeReplay(folder_ / "real.gwr", sampleReplay());
  fs::create_symlink("real.gwr", folder_ / "link.gwr");
  writeReplay(folder_ / "link.gwr", sampleReplay());
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.gwr"));
}

TEST_F(ReplayFiles, RefuseWhatCannotBeWritten) {
  EXPECT_TRUE(contains(writing(folder_ / "none" / "a.gwr"), "No such file or directory; choose a folder"));
  EXPECT_TRUE(contains(writing(folder_), "it is a folder"));
  EXPECT_TRUE(contains(writing(""), "its name is empty"));
  EXPECT_TRUE(contains(writing("/dev/null"), "not a plain file"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(contains(writing(folder_ / std::string(300, 'x')), "File name too long"));
  EXPECT_EQ(filesThere(), 0u);
}

TEST_F(ReplayFiles, RefuseReadOnlyFolders) {
  chmod(folder_.c_str(), 0555);
  const WithoutPrivileges now;
  if (!now.dropped()) GTEST_SKIP() << "root may write everywhere";
  EXPECT_TRUE(contains(writing(folder_ / "a.gwr"), "Permission denied; choose a folder"));
}

TEST_F(ReplayFiles, RefuseWriteProtectedFiles) {
  std::ofstream(folder_ / "a.gwr") << "mine";
  chmod((folder_ / "a.gwr").c_str(), 0444);
  chmod(folder_.c_str(), 0777);
  const WithoutPrivileges now;
  if (!now.dropped()) GTEST_SKIP() << "root may write everywhere";
  EXPECT_TRUE(contains(writing(folder_ / "a.gwr"), "write-protected"));
}

// A disk that fills up while writing, by way of a limit on file sizes.
TEST_F(ReplayFiles, FailedWritesKeepTheOlderFileAndLeaveNothing) {
  std::ofstream(folder_ / "a.gwr") << "older";
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string said = writing(folder_ / "a.gwr");
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);

  EXPECT_TRUE(contains(said, "File too large; make room")) << said;
  EXPECT_EQ(filesThere(), 1u);
  std::string content;
  std::ifstream(folder_ / "a.gwr") >> content;
  EXPECT_EQ(content, "older");
}

TEST_F(ReplayFiles, ReaderNamesWhatIsNoReplay) {
  std::ofstream(folder_ / "empty.gwr");
  std::ofstream(folder_ / "text.gwr") << "hello\n";
  EXPECT_TRUE(contains(reading(folder_ / "none.gwr"), "there is no such file"));
  EXPECT_TRUE(contains(reading(folder_ / "empty.gwr"), "the file is empty"));
  EXPECT_TRUE(contains(reading(folder_ / "text.gwr"), "a text file"));
  EXPECT_TRUE(contains(reading(folder_), "not a plain file"));
  EXPECT_TRUE(contains(reading("/dev/zero"), "not a plain file"));
  std::ofstream(folder_ / "huge.gwr");
  fs::resize_file(folder_ / "huge.gwr", uint64_t(1) << 40);  // sparse
  EXPECT_TRUE(contains(reading(folder_ / "huge.gwr"), "larger than 64 MiB"));
}

}  // namespace
}  // namespace gw::test
