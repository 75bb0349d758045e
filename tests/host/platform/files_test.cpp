// What is written: whole or not at all, with the permissions and the owner that it had, and a remedy for each cause.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "host/platform/append_file.h"
#include "host/platform/atomic_file.h"
#include "host/platform/remedy.h"
#include "host/platform/replace_file.h"
#include "host/platform/unfinished_file.h"

namespace gw::test {
namespace {

namespace fs = std::filesystem;

std::span<const uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

class Written : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "gw_files_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path put(const char* name, const std::string& text, mode_t mode) const {
    const fs::path path = folder_ / name;
    std::ofstream(path, std::ios::binary) << text;
    chmod(path.c_str(), mode);
    return path;
  }
  static std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static mode_t modeOf(const fs::path& path) {
    struct stat facts {};
    return stat(path.c_str(), &facts) == 0 ? facts.st_mode & 07777 : 0;
  }
  size_t filesThere() const { return size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }

  static std::string refusal(const std::function<void()>& work) {
    try {
      work();
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(Written, AFileKeepsItsPermissions) {
  const mode_t mask = umask(022);
  for (const mode_t mode : {0600, 0640, 0666, 0755}) {
    const fs::path path = put("old", "old", mode);
    writeFileAtomically(path, bytesOf("new"));
    EXPECT_EQ(content(path), "new");
    EXPECT_EQ(modeOf(path), mode);
    AppendFile growing(path);
    EXPECT_EQ(modeOf(growing.path()), mode) << "so what only its owner may read is never readable by others";
    growing.append(bytesOf("grown"));
    growing.become();
    EXPECT_EQ(content(path), "grown");
    EXPECT_EQ(modeOf(path), mode);
  }
  writeFileAtomically(folder_ / "new", bytesOf("new"));
  EXPECT_EQ(modeOf(folder_ / "new"), mode_t(0644)) << "a new one has the usual ones";
  umask(mask);
}

TEST_F(Written, AFileKeepsItsOwner) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  const fs::path path = put("old", "old", 0640);
  ASSERT_EQ(chown(path.c_str(), 12, 34), 0);
  writeFileAtomically(path, bytesOf("new"));
  struct stat facts {};
  ASSERT_EQ(stat(path.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_uid, 12u);
  EXPECT_EQ(facts.st_gid, 34u);
  EXPECT_EQ(modeOf(path), mode_t(0640));
}

// A file of another user in a folder where names cannot be taken from others.
TEST_F(Written, AFileWhoseNameCannotBeTakenGetsTheBytes) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  chmod(folder_.c_str(), 01777);
  const std::string large(100'000, 'x');
  for (const std::string& text : {std::string("shorter"), large, std::string()}) {
    const fs::path path = put("other", "what stood there before", 0666);
    ASSERT_EQ(chown(path.c_str(), 12, 34), 0);
    struct stat before {
    }, after{};
    ASSERT_EQ(stat(path.c_str(), &before), 0);
    const pid_t child = fork();
    if (child == 0) {
      _exit(seteuid(56) == 0 && refusal([&] { writeFileAtomically(path, bytesOf(text)); }).empty() ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(content(path), text);
    ASSERT_EQ(stat(path.c_str(), &after), 0);
    EXPECT_EQ(after.st_ino, before.st_ino);
    EXPECT_EQ(filesThere(), 1u) << "no part is left";
  }
}

TEST_F(Written, WhatDoesNotFitInPlaceLeavesWhatStoodThere) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  chmod(folder_.c_str(), 01777);
  const fs::path path = put("other", "what stood there before", 0666);
  ASSERT_EQ(chown(path.c_str(), 12, 34), 0);
  const pid_t child = fork();
  if (child == 0) {
    // The part is whole; the room for it goes before its bytes are needed elsewhere.
    std::string part = (folder_ / "part").string();
    std::ofstream(part) << std::string(10'000, 'x');
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{5'000, 5'000};
    const bool set = setrlimit(RLIMIT_FSIZE, &small) == 0 && chown(part.c_str(), 56, 56) == 0 && seteuid(56) == 0;
    const std::string said = refusal([&] { replaceFile(part, path, path, Sync::now); });
    _exit(set && said.find("make room") != said.npos && !part.empty() ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(content(path), "what stood there before");
}

TEST_F(Written, ARemedyForEachCause) {
  EXPECT_NE(refusal([&] { checkWritable(folder_ / "none" / "file"); }).find("choose a folder that exists"),
            std::string::npos);
  EXPECT_NE(refusal([&] { checkWritable(put("file", "x", 0644) / "below"); }).find("choose a folder that exists"),
            std::string::npos);
  const std::string longName(300, 'x');
  EXPECT_NE(refusal([&] { checkWritable(folder_ / longName); }).find("choose another name"), std::string::npos);
  for (const int error : {ENOSPC, EDQUOT, EFBIG}) EXPECT_NE(because(error).find("; make room"), std::string::npos);
  for (const int error : {EACCES, EPERM, EROFS}) {
    EXPECT_NE(because(error).find("; choose a folder that you may write to"), std::string::npos);
  }
  EXPECT_NE(becauseNoFolder(ENOENT).find("; choose a folder inside one that exists"), std::string::npos);
  EXPECT_NE(becauseNoFolder(ENOSPC).find("; make room"), std::string::npos);
  // In the system's own words, as programs of the same system say them.
  for (const int error : {ENOSPC, EDQUOT, EFBIG, ENOENT, ENOTDIR, EACCES, EPERM, EROFS, EIO}) {
    EXPECT_EQ(errorNamedIn("x: " + because(error)), error);
  }
  EXPECT_EQ(errorNamedIn("out of paper"), 0);
  EXPECT_EQ(errorNamedIn(""), 0);
}

TEST_F(Written, UnfinishedFilesGoWithTheProgramUnlessTheyAreKept) {
  const fs::path lost = put("lost", "x", 0644), spared = put("spared", "x", 0644), gone = put("gone", "x", 0644);
  const UnfinishedFile one(lost.string());
  UnfinishedFile two(spared.string());
  { const UnfinishedFile three(gone.string()); }
  two.keep();
  removeUnfinishedFiles();
  EXPECT_FALSE(fs::exists(lost));
  EXPECT_TRUE(fs::exists(spared));
  EXPECT_TRUE(fs::exists(gone));
}

}  // namespace
}  // namespace gw::test
