// Which moments become frames, and where frames go.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#include "game/view/frame_times.h"
#include "host/platform/atomic_file.h"
#include "host/platform/piped_process.h"
#include "host/platform/user_error.h"
#include "host/video/mp4_check.h"
#include "host/video/mp4_writer.h"
#include "host/video/png_sequence.h"

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
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(Folders, TakeNumberedPicturesAndRefuseASecondRender) {
  PngSequence sink(folder_ / "frames");
  sink.add(picture());
  sink.add(picture());
  EXPECT_TRUE(fs::exists(folder_ / "frames/frame_000001.png"));
  EXPECT_TRUE(fs::exists(folder_ / "frames/frame_000002.png"));
  EXPECT_EQ(count(folder_ / "frames"), 2u);
  EXPECT_NE(refusal([&] { PngSequence(folder_ / "frames"); }).find("give an empty folder"), std::string::npos);
  std::ofstream(folder_ / "notes.txt") << "anything else may stand there";
  EXPECT_EQ(refusal([&] { PngSequence{folder_}; }), "");
}

TEST_F(Folders, RefuseWhatIsNoFolder) {
  std::ofstream(folder_ / "file") << "x";
  EXPECT_NE(refusal([&] { PngSequence(folder_ / "file"); }).find("it is a file"), std::string::npos);
  EXPECT_NE(refusal([&] { PngSequence(folder_ / "file/below"); }).find("choose a folder inside"), std::string::npos);
  EXPECT_NE(refusal([&] { PngSequence(folder_ / "none/below"); }).find("choose a folder inside"), std::string::npos);
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
  PngSequence sink(folder_);
  const NoRoom full(2000);
  EXPECT_NE(refusal([&] { sink.add(picture()); }).find("make room"), std::string::npos);
  EXPECT_EQ(count(folder_), 0u);
}

bool haveFfmpeg() {
  try {
    return PipedProcess({"ffmpeg", "-version"}).wait() == 0;
  } catch (const std::system_error&) {
    return false;
  }
}

TEST_F(Folders, FilmsTakeTheirNameWhenTheyAreWhole) {
  if (!haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const fs::path film = folder_ / "a film: 'x'.mp4";
  {
    Mp4Writer left(film, {64, 48}, 60);
    left.add(picture());
  }
  EXPECT_EQ(count(folder_), 0u) << "one that was not finished leaves nothing";
  Mp4Writer sink(film, {64, 48}, 60);
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
    Mp4Writer sink(film, {640, 480}, 60);
    const NoRoom full(2000);
    const std::string why = refusal([&] {
      Mp4Writer small(film, {640, 480}, 60);  // started with the limit
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

// A program of that name is found before the real one while this lives.
class Stand {
 public:
  Stand(const fs::path& folder, const std::string& script) : before_(std::getenv("PATH")) {
    fs::create_directory(folder);
    std::ofstream(folder / "ffmpeg") << "#!/bin/sh\n" + script + "\n";
    fs::permissions(folder / "ffmpeg", fs::perms::all);
    setenv("PATH", (folder.string() + ":" + before_).c_str(), 1);
  }
  ~Stand() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

// Asked what it can do it says nothing. Else: the last argument names the part.
constexpr const char* kPart =
    "case \"$*\" in *-encoders*) exit 0;; esac; for part; do :; done; part=${part#file:}; cat > /dev/null; ";

std::string bytesOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(Folders, AnFfmpegThatMakesNoFilmIsNoticedAndTheEarlierFilmStays) {
  const fs::path film = folder_ / "film.mp4", programs = folder_ / "programs";
  std::ofstream(film) << "an earlier film";
  std::string type = "printf '\\000\\000\\000\\020ftypisom\\000\\000\\002\\000' > \"$part\"; ";
  const std::pair<std::string, std::vector<std::string>> cases[] = {
      {"exit 0", {"ffmpeg ended well but wrote nothing to ", "a snap or Flatpak sees other folders", "apt install"}},
      {"rm \"$part\"", {"ffmpeg ended well but wrote nothing to "}},
      {"echo film > \"$part\"", {"ffmpeg ended well but what it wrote to ", "is not a film, whole"}},
      {type, {"is not a film, whole"}},
      {type + "printf '\\000\\000\\001\\000moov' >> \"$part\"", {"is not a film, whole"}},
      {"echo '[out#0/mp4 @ 0x5] Error opening output x: No such file or directory' >&2; echo last >&2; exit 1",
       {"(Error opening output x: No such file or directory)", "sees other folders"}},
      {"echo 'x: Permission denied' >&2; exit 1", {"(x: Permission denied)", "sees other folders"}},
      {"echo first; echo '[a @ 0x1] [b @ 0x2] w: No space left on device'; echo '[c @ 0x3] nothing was written'; exit "
       "1",
       {"(w: No space left on device)", "make room"}},
      {"echo 'Unknown encoder'; echo 'Conversion failed!'; exit 1", {"(Unknown encoder): give a folder as --out"}},
      {"exit 7", {"(it ended with 7): give a folder as --out"}},
  };
  for (const auto& [instead, says] : cases) {
    const Stand stand(programs, kPart + instead);
    const std::string said = refusal([&] {
      Mp4Writer sink(film, {64, 48}, 60);
      for (int i = 0; i < 3; ++i) sink.add(picture());
      sink.finish();
    });
    for (const std::string& word : says) EXPECT_NE(said.find(word), std::string::npos) << instead << ": " << said;
    EXPECT_EQ(said.find("0x"), std::string::npos) << said;
    EXPECT_EQ(said.find("make room") != said.npos, instead.find("No space") != instead.npos) << said;
    EXPECT_EQ(bytesOf(film), "an earlier film") << instead;
    EXPECT_EQ(count(folder_), 2u) << instead << ": a part is left";
  }
}

TEST_F(Folders, AFilmThatWasCutShortIsNone) {
  if (!haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const fs::path film = folder_ / "film.mp4", cut = folder_ / "cut.mp4";
  Mp4Writer sink(film, {64, 48}, 60);
  for (int i = 0; i < 5; ++i) sink.add(picture());
  sink.finish();
  EXPECT_TRUE(isWholeMp4(film));
  const std::string bytes = bytesOf(film);
  for (size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 97) {
    std::ofstream(cut, std::ios::binary) << bytes.substr(0, length);
    EXPECT_FALSE(isWholeMp4(cut)) << length << " of " << bytes.size();
  }
  EXPECT_FALSE(isWholeMp4(folder_ / "none.mp4"));
}

// What a player shows is what was drawn. A film with a wrong colour space in its header shows red as 232,0,1.
void expectTrueColours(const fs::path& film) {
  constexpr int kSide = 64;
  constexpr uint8_t kColours[][3] = {{255, 0, 0},   {0, 255, 0},     {0, 0, 255},     {255, 255, 0}, {255, 0, 255},
                                     {0, 255, 255}, {255, 255, 255}, {128, 128, 128}, {0, 0, 0},     {200, 60, 20}};
  constexpr int kCount = int(std::size(kColours));
  Image bars{{kSide * kCount, kSide}, {}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide * kCount; ++x) {
      bars.rgb.insert(bars.rgb.end(), std::begin(kColours[x / kSide]), std::end(kColours[x / kSide]));
    }
  }
  Mp4Writer sink(film, bars.size, 60);
  for (int i = 0; i < 3; ++i) sink.add(bars);
  sink.finish();
  PipedProcess decoder({"ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-i", film.string(), "-frames:v",
                        "1", "-f", "rawvideo", "-pix_fmt", "rgb24", film.string() + ".rgb", "-y"});
  ASSERT_EQ(decoder.wait(), 0) << decoder.output();
  const std::string rgb = bytesOf(film.string() + ".rgb");
  ASSERT_EQ(rgb.size(), bars.rgb.size());
  for (int bar = 0; bar < kCount; ++bar) {
    const size_t middle = (size_t(kSide / 2) * kSide * kCount + size_t(bar) * kSide + kSide / 2) * 3;
    for (size_t channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(int(uint8_t(rgb[middle + channel])), kColours[bar][channel], 5) << "bar " << bar << " of " << film;
    }
  }
  PipedProcess probe({"ffprobe", "-v", "error", "-select_streams", "v", "-show_entries",
                      "stream=color_range,color_space,color_transfer,color_primaries", "-of", "csv=p=0",
                      film.string()});
  EXPECT_EQ(probe.wait(), 0);
  EXPECT_EQ(probe.output(), "tv,bt709,bt709,bt709\n") << film;
}

TEST_F(Folders, FilmsShowTheColoursThatWereDrawn) {
  if (!haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  expectTrueColours(folder_ / "best.mp4");
  PipedProcess where({"sh", "-c", "command -v ffmpeg"});
  ASSERT_EQ(where.wait(), 0);
  const std::string real = where.output().substr(0, where.output().find('\n'));
  const Stand poor(folder_ / "programs", "case \"$*\" in *-encoders*) exit 0;; esac; exec " + real + " \"$@\"");
  expectTrueColours(folder_ / "mpeg4.mp4");
}

TEST(PipedProcess, SaysThatAProgramIsNotThereAndHowItEnded) {
  try {
    PipedProcess({"no-such-program-anywhere"});
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ENOENT);
  }
  PipedProcess echo({"cat", "-"});
  const std::string words = "several words; $HOME `x`";
  EXPECT_TRUE(echo.write({reinterpret_cast<const uint8_t*>(words.data()), words.size()}));
  EXPECT_EQ(echo.wait(), 0);
  EXPECT_EQ(echo.output(), words);
  PipedProcess argument({"printf", "%s", "$HOME *"});
  EXPECT_EQ(argument.wait(), 0);
  EXPECT_EQ(argument.output(), "$HOME *");
  PipedProcess deaf({"false"});
  const std::vector<uint8_t> much(1 << 20);
  EXPECT_FALSE(deaf.write(much)) << "a program that does not read is noticed, not died of";
  EXPECT_EQ(deaf.wait(), 1);
}

}  // namespace
}  // namespace gw::test
