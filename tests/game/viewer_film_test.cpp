// Which moments become frames, and where frames go.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <random>

#include "game/files/atomic_file.h"
#include "game/processes/fed_process.h"
#include "game/movie/film_file.h"
#include "game/movie/frame_times.h"
#include "game/movie/picture_folder.h"
#include "game/user_error.h"

namespace gw::test {
namespace {

namespace fs = std::filesystem;

TEST(FrameTimes, DrawEverySecondTickEveryTickOrTwiceATick) {
  EXPECT_EQ(framesOf(9, {10, 20, 60}), std::vector<float>{});
  EXPECT_EQ(framesOf(21, {10, 20, 60}), std::vector<float>{});
  EXPECT_EQ(framesOf(10, {10, 20, 60}), std::vector<float>{1});
  EXPECT_EQ(framesOf(10, {10, 20, 30}), std::vector<float>{1});
  EXPECT_EQ(framesOf(11, {10, 20, 30}), std::vector<float>{});
  EXPECT_EQ(framesOf(20, {10, 20, 120}), (std::vector<float>{0.5f, 1}));
}

TEST(FrameTimes, CountWhatTheyDraw) {
  for (const uint32_t fps : {30u, 60u, 120u}) {
    for (const FrameRange range : {FrameRange{1, 1, fps}, FrameRange{1, 60, fps}, FrameRange{7, 13, fps}}) {
      uint64_t frames = 0;
      for (uint32_t tick = 1; tick <= 70; ++tick) frames += framesOf(tick, range).size();
      EXPECT_EQ(frames, frameCount(range)) << fps << " from " << range.from;
    }
  }
}

class Folders : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("gpuwars_film_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static Image picture(int width = 64, int height = 48) {
    Image image{{width, height}, std::vector<uint8_t>(size_t(width) * size_t(height) * 3)};
    std::mt19937 dice(1);
    for (uint8_t& byte : image.rgb) byte = uint8_t(dice());  // does not compress
    return image;
  }

  static size_t count(const fs::path& folder) {
    return size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  template <class Work>
  static std::string refusal(const Work& work) {
    try {
      work();
    } catch (const UserError& error) {
      return error.what();
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(Folders, TakeNumberedPicturesAndRefuseASecondRender) {
  PictureFolder sink(folder_ / "frames");
  sink.add(picture());
  sink.add(picture());
  EXPECT_TRUE(fs::exists(folder_ / "frames/frame_000001.png"));
  EXPECT_TRUE(fs::exists(folder_ / "frames/frame_000002.png"));
  EXPECT_EQ(count(folder_ / "frames"), 2u);
  EXPECT_NE(refusal([&] { PictureFolder(folder_ / "frames"); }).find("give an empty folder"), std::string::npos);
  std::ofstream(folder_ / "notes.txt") << "anything else may stand there";
  EXPECT_EQ(refusal([&] { PictureFolder{folder_}; }), "");
}

TEST_F(Folders, RefuseWhatIsNoFolder) {
  std::ofstream(folder_ / "file") << "x";
  EXPECT_NE(refusal([&] { PictureFolder(folder_ / "file"); }).find("it is a file"), std::string::npos);
  EXPECT_NE(refusal([&] { PictureFolder(folder_ / "file/below"); }).find("choose a folder inside"), std::string::npos);
  EXPECT_NE(refusal([&] { PictureFolder(folder_ / "none/below"); }).find("choose a folder inside"), std::string::npos);
}

// Files that may not grow: what a full disk does, without one.
class NoRoom {
 public:
  explicit NoRoom(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~NoRoom() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST_F(Folders, LeaveNoHalfPictureWhereThereIsNoRoom) {
  PictureFolder sink(folder_);
  const NoRoom full(2000);
  EXPECT_NE(refusal([&] { sink.add(picture()); }).find("with room on its disk"), std::string::npos);
  EXPECT_EQ(count(folder_), 0u);
}

bool haveFfmpeg() {
  try {
    return FedProcess({"ffmpeg", "-version"}).wait() == 0;
  } catch (const std::system_error&) {
    return false;
  }
}

TEST_F(Folders, FilmsTakeTheirNameWhenTheyAreWhole) {
  if (!haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const fs::path film = folder_ / "a film: 'x'.mp4";
  {
    FilmFile left(film, {64, 48}, 60);
    left.add(picture());
  }
  EXPECT_EQ(count(folder_), 0u) << "one that was not finished leaves nothing";
  FilmFile sink(film, {64, 48}, 60);
  for (int i = 0; i < 5; ++i) sink.add(picture());
  EXPECT_FALSE(fs::exists(film));
  sink.finish();
  EXPECT_GT(fs::file_size(film), 500u);
  EXPECT_EQ(count(folder_), 1u);
}

TEST_F(Folders, FilmsThatCannotBeSayWhyAndLeaveWhatStoodThere) {
  if (!haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const fs::path film = folder_ / "film.mp4";
  std::ofstream(film) << "what stood there";
  {
    FilmFile sink(film, {640, 480}, 60);
    const NoRoom full(2000);
    const std::string why = refusal([&] {
      FilmFile small(film, {640, 480}, 60);  // started with the limit
      for (int i = 0; i < 200; ++i) small.add(picture(640, 480));
      small.finish();
    });
    EXPECT_NE(why.find("ffmpeg could not make"), std::string::npos) << why;
  }
  std::string text;
  std::getline(std::ifstream(film), text);
  EXPECT_EQ(text, "what stood there");
  EXPECT_EQ(count(folder_), 1u);
}

TEST(FedProcess, SaysThatAProgramIsNotThereAndHowItEnded) {
  try {
    FedProcess({"no-such-program-anywhere"});
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ENOENT);
  }
  FedProcess echo({"cat", "-"});
  const std::string words = "several words; $HOME `x`";
  EXPECT_TRUE(echo.write({reinterpret_cast<const uint8_t*>(words.data()), words.size()}));
  EXPECT_EQ(echo.wait(), 0);
  EXPECT_EQ(echo.output(), words);
  FedProcess argument({"printf", "%s", "$HOME *"});
  EXPECT_EQ(argument.wait(), 0);
  EXPECT_EQ(argument.output(), "$HOME *");
  FedProcess deaf({"false"});
  const std::vector<uint8_t> much(1 << 20);
  EXPECT_FALSE(deaf.write(much)) << "a program that does not read is noticed, not died of";
  EXPECT_EQ(deaf.wait(), 1);
}

}  // namespace
}  // namespace gw::test
