// Settings on disk: nothing of the player's is lost, whatever the disk does.
#include "game/settings/settings_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/game/settings/settings_samples.h"

namespace gw::test {
namespace {

namespace fs = std::filesystem;

class SettingsOnDisk : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "gw_settings_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    path_ = folder_ / "settings.toml";
  }
  void TearDown() override { fs::remove_all(folder_); }

  size_t filesThere() const { return size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator())); }
  static std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void put(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }
  Settings read(SettingsFile& file) {
    said.clear();
    return file.read(said);
  }
  // Everything that is not so by default.
  void write(SettingsFile& file, const Settings& settings) { change(file, Settings(), settings); }
  void change(SettingsFile& file, const Settings& before, const Settings& now) {
    said.clear();
    file.write(before, now, said);
  }

  fs::path folder_, path_;
  std::vector<std::string> said;
};

TEST_F(SettingsOnDisk, NoFileMeansDefaultsAndNothingToSay) {
  SettingsFile file(path_);
  EXPECT_EQ(read(file), Settings());
  EXPECT_TRUE(said.empty());
  EXPECT_EQ(filesThere(), 0u) << "reading leaves nothing";
}

TEST_F(SettingsOnDisk, AreKeptInFoldersThatAreMade) {
  const fs::path deep = folder_ / "a" / "b" / "settings.toml";
  SettingsFile file(deep), other(deep);
  write(file, otherSettings());
  EXPECT_TRUE(said.empty()) << said.front();
  EXPECT_EQ(read(other), otherSettings());
  EXPECT_TRUE(said.empty());
  change(other, otherSettings(), Settings());
  EXPECT_EQ(read(file), Settings());
  EXPECT_EQ(size_t(std::distance(fs::directory_iterator(deep.parent_path()), fs::directory_iterator())), 1u);
}

TEST_F(SettingsOnDisk, ADamagedFileIsKeptBesideTheNewOne) {
  put("this is [ no TOML");
  SettingsFile file(path_);
  EXPECT_EQ(read(file), Settings());
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(content(path_), "this is [ no TOML") << "reading changes nothing";

  write(file, otherSettings());
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("settings.toml.bad"), std::string::npos) << said[0];
  EXPECT_EQ(content(folder_ / "settings.toml.bad"), "this is [ no TOML");
  EXPECT_EQ(read(file), otherSettings());

  change(file, otherSettings(), Settings());
  EXPECT_TRUE(said.empty()) << "once is enough";
  EXPECT_EQ(read(file), Settings());
  EXPECT_EQ(filesThere(), 2u);
}

TEST_F(SettingsOnDisk, NoEarlierDamagedFileIsLostEither) {
  std::ofstream(folder_ / "settings.toml.bad") << "older";
  put("[sound]\nmusic = 9\n");
  SettingsFile file(path_);
  read(file);
  write(file, Settings());
  EXPECT_EQ(content(folder_ / "settings.toml.bad"), "older");
  EXPECT_EQ(content(folder_ / "settings.toml.bad-2"), "[sound]\nmusic = 9\n");
}

TEST_F(SettingsOnDisk, UnknownKeysSurviveWithoutACopy) {
  put("[sound]\nreverb = 3\n");
  SettingsFile file(path_);
  read(file);
  EXPECT_EQ(said.size(), 1u);
  write(file, otherSettings());
  EXPECT_TRUE(said.empty());
  EXPECT_EQ(filesThere(), 1u);
  EXPECT_NE(content(path_).find("reverb = 3"), std::string::npos);
}

TEST_F(SettingsOnDisk, AFullDiskKeepsTheOlderFileAndIsSaid) {
  SettingsFile file(path_);
  write(file, otherSettings());
  const std::string older = content(path_);
  const auto onFullDisk = [&](SettingsFile& target) {
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{100, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    change(target, otherSettings(), Settings());
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
  };
  onFullDisk(file);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("make room"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("hold until the game ends"), std::string::npos) << said[0];
  EXPECT_EQ(content(path_), older);
  EXPECT_EQ(filesThere(), 1u) << "no part of a file is left";

  // With a damaged one there is no room for its copy either: it stays.
  const std::string damaged = "music = [" + std::string(200, ' ');
  put(damaged);
  SettingsFile second(path_);
  read(second);
  onFullDisk(second);
  EXPECT_EQ(content(path_), damaged);
  EXPECT_EQ(filesThere(), 1u);
  ASSERT_EQ(said.size(), 1u);
  write(second, Settings());  // there is room again
  EXPECT_EQ(content(folder_ / "settings.toml.bad"), damaged);
  EXPECT_EQ(read(second), Settings());
}

TEST_F(SettingsOnDisk, FoldersThatTakeNoFilesAreNamed) {
  std::ofstream(folder_ / "file") << "x";
  for (const fs::path& path : {folder_ / "file" / "settings.toml", fs::path("/proc/gpuwars/settings.toml")}) {
    SettingsFile file(path);
    read(file);
    write(file, otherSettings());
    ASSERT_EQ(said.size(), 1u) << path;
    EXPECT_NE(said[0].find(path.string()), std::string::npos) << said[0];
    EXPECT_NE(said[0].find("choose another place"), std::string::npos) << said[0];
  }
}

TEST_F(SettingsOnDisk, WhatIsNoPlainFileIsNamedAndLeftAlone) {
  fs::create_directory(path_);
  mkfifo((folder_ / "pipe").c_str(), 0600);
  for (const fs::path& path : {path_, folder_ / "pipe", fs::path("/dev/zero")}) {
    SettingsFile file(path);
    EXPECT_EQ(read(file), Settings());
    ASSERT_EQ(said.size(), 1u) << path;
    EXPECT_NE(said[0].find("not a plain file"), std::string::npos) << said[0];
    write(file, Settings());
    EXPECT_EQ(said.size(), 1u) << path;
    EXPECT_FALSE(fs::is_regular_file(path));
  }
}

// The file while a game runs with what it held before.
constexpr const char* kEdited = R"(# my own
[sound]
effects = 0.80  # as loud as it goes
music = 0.3
[keys]
flush = ["Left Shift"]
[smell]
roses = 0.7
)";

TEST_F(SettingsOnDisk, WhatSomebodyWritesMeanwhileStays) {
  SettingsFile file(path_);
  const Settings before = read(file);
  put(kEdited);
  Settings now = before;
  now.sound.effects = 0.85f;
  change(file, before, now);
  EXPECT_TRUE(said.empty()) << said.front();
  std::string expected = kEdited;
  expected.replace(expected.find("0.80"), 4, "0.85");
  EXPECT_EQ(content(path_), expected) << "to the byte";
  EXPECT_EQ(filesThere(), 1u) << "and no copy is needed";
}

TEST_F(SettingsOnDisk, TwoGamesChangeWhatEachOfThemChanges) {
  SettingsFile first(path_), second(path_);
  const Settings before = read(first);
  Settings one = before, two = before, third = before;
  one.sound.effects = 0.85f;
  two.sound.music = 0.65f;
  two.bindings.codes(InputDevice::keyboard, Action::flush) = {225};
  change(first, before, one);
  change(second, before, two);
  third.sound.effects = 0.85f;
  third.sound.music = 0.65f;
  third.bindings = two.bindings;
  EXPECT_EQ(read(first), third);
  one.sound.muted = true;  // the first does not know of the second, and does not undo it
  change(first, before, one);
  third.sound.muted = true;
  EXPECT_EQ(read(first), third);
}

TEST_F(SettingsOnDisk, WhatHeldForTheSessionOnlyIsNotSaved) {
  SettingsFile file(path_);
  Settings before = read(file);
  before.video.fullscreen = true;  // --fullscreen
  Settings now = before;
  now.sound.music = 0.1f;
  change(file, before, now);
  EXPECT_FALSE(read(file).video.fullscreen);
  EXPECT_EQ(read(file).sound.music, 0.1f);
}

TEST_F(SettingsOnDisk, WhatCouldNotBeSavedIsSavedWithTheNextChange) {
  SettingsFile file(folder_ / "file" / "settings.toml");
  std::ofstream(folder_ / "file") << "x";
  const Settings start;
  Settings first = start, second = start;
  first.sound.music = second.sound.music = 0.1f;
  second.sound.effects = 0.2f;
  change(file, start, first);
  EXPECT_EQ(said.size(), 1u);
  fs::remove(folder_ / "file");
  change(file, first, second);
  EXPECT_TRUE(said.empty()) << said.front();
  EXPECT_EQ(read(file), second);
}

TEST_F(SettingsOnDisk, PermissionsAndLinksStay) {
  put(kEdited);
  chmod(path_.c_str(), 0600);
  const fs::path link = folder_ / "link.toml";
  fs::create_symlink("settings.toml", link);
  SettingsFile file(link);
  const Settings before = read(file);
  Settings now = before;
  now.sound.muted = true;
  change(file, before, now);
  EXPECT_TRUE(said.empty()) << said.front();
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_NE(content(path_).find("muted = true"), std::string::npos);
  EXPECT_EQ(fs::status(path_).permissions(), fs::perms(0600));
  if (geteuid() != 0) return;
  ASSERT_EQ(chown(path_.c_str(), 12, 34), 0);  // root plays, and the file stays its owner's
  change(file, now, before);
  struct stat facts {};
  ASSERT_EQ(stat(path_.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_uid, 12u);
  EXPECT_EQ(facts.st_gid, 34u);
}

TEST_F(SettingsOnDisk, WithoutAPlaceTheyHoldForTheSession) {
  SettingsFile file("");
  EXPECT_EQ(read(file), Settings());
  EXPECT_TRUE(said.empty());
  write(file, otherSettings());
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("HOME"), std::string::npos);
}

TEST_F(SettingsOnDisk, TheUsualPlaceFollowsTheEnvironment) {
  const auto with = [](const char* config, const char* home) {
    config ? setenv("XDG_CONFIG_HOME", config, 1) : unsetenv("XDG_CONFIG_HOME");
    home ? setenv("HOME", home, 1) : unsetenv("HOME");
    return usualSettingsPath();
  };
  EXPECT_EQ(with("/config", "/my"), "/config/gpuwars/settings.toml");
  EXPECT_EQ(with(nullptr, "/my"), "/my/.config/gpuwars/settings.toml");
  EXPECT_EQ(with("", "/my"), "/my/.config/gpuwars/settings.toml");
  EXPECT_EQ(with("relative", "/my"), "/my/.config/gpuwars/settings.toml");
  EXPECT_EQ(with(nullptr, nullptr), "");
}

}  // namespace
}  // namespace gw::test
