// Sound files: the game's own, and every way in which one can be damaged.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <fstream>

#include "tests/game/audio/audio_listener.h"

namespace gw::test {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<uint8_t>;

void put(Bytes& bytes, size_t at, uint32_t value, uint32_t size) {
  for (uint32_t i = 0; i < size; ++i) bytes[at + i] = uint8_t(value >> (8 * i));
}

// A sound of 100 samples. Its parts: RIFF 0, fmt chunk 12 (size 16, data 20), data chunk 36 (size 40, data 44).
Bytes soundFile() {
  Bytes bytes(44 + 200);
  std::memcpy(bytes.data(), "RIFF....WAVEfmt ", 16);
  put(bytes, 4, uint32_t(bytes.size() - 8), 4);
  put(bytes, 16, 16, 4);
  put(bytes, 20, 1, 2);
  put(bytes, 22, 1, 2);
  put(bytes, 24, 44100, 4);
  put(bytes, 28, 88200, 4);
  put(bytes, 32, 2, 2);
  put(bytes, 34, 16, 2);
  std::memcpy(bytes.data() + 36, "data", 4);
  put(bytes, 40, 200, 4);
  for (uint32_t i = 0; i < 100; ++i) put(bytes, 44 + 2 * i, uint32_t(int32_t(i) * 300 - 15000), 2);
  return bytes;
}

// A folder that goes with the test.
class SoundFolder {
 public:
  SoundFolder() : path_(fs::path(testing::TempDir()) / (name() + ".sounds")) {
    fs::remove_all(path_);
    fs::create_directories(path_);
    for (const SoundTraits& traits : kSoundTraits) write(traits.name, soundFile());
    write("music", soundFile());
  }
  ~SoundFolder() { fs::remove_all(path_); }

  fs::path file(const std::string& name) const { return path_ / (name + ".wav"); }
  void write(const std::string& name, const Bytes& bytes) const {
    std::ofstream(file(name), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  }
  SoundBank load(std::vector<std::string>& sentences) const {
    return loadSounds(path_, [&](const std::string& sentence) { sentences.push_back(sentence); });
  }
  const fs::path& path() const { return path_; }

 private:
  static std::string name() {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
  }
  fs::path path_;
};

TEST(SoundFiles, ReadsWhatItHolds) {
  const Clip clip = parseWav(soundFile());
  EXPECT_EQ(clip.rate_hz, 44100u);
  ASSERT_EQ(clip.samples.size(), 100u);
  EXPECT_EQ(clip.samples[0], -15000);
  EXPECT_EQ(clip.samples[99], 99 * 300 - 15000);
}

TEST(SoundFiles, SkipsOtherChunks) {
  Bytes bytes = soundFile();
  const uint8_t list[] = {'L', 'I', 'S', 'T', 3, 0, 0, 0, 'a', 'b', 'c', 0};  // odd: a byte follows
  bytes.insert(bytes.begin() + 36, std::begin(list), std::end(list));
  EXPECT_EQ(parseWav(bytes).samples.size(), 100u);
}

TEST(SoundFiles, TheGamesOwnHaveHeadRoomAndAreSmall) {
  uintmax_t total = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(GW_ASSETS_DIR) / "sounds")) total += entry.file_size();
  EXPECT_LT(total, uintmax_t(2500) << 10);
  std::vector<const Clip*> clips{&gameSounds().music};
  for (const Clip& clip : gameSounds().effects) clips.push_back(&clip);
  for (const Clip* clip : clips) {
    ASSERT_FALSE(clip->samples.empty());
    int peak = 0;
    for (const int16_t sample : clip->samples) peak = std::max(peak, std::abs(int(sample)));
    EXPECT_NEAR(peak / 32768.0, 0.85, 0.01);
  }
}

TEST(SoundFiles, EffectsEndInSilence) {
  for (const Clip& clip : gameSounds().effects) EXPECT_LT(std::abs(int(clip.samples.back())), 33);
}

TEST(SoundFiles, PeaksAreOfWhatIsStillToCome) {
  Clip clip{6000, std::vector<int16_t>(1000, 0)};  // 100 samples to 1/60 s
  clip.samples[0] = -32768;
  clip.samples[250] = 16384;
  const std::vector<float> peaks = peaksFrom(clip);
  EXPECT_EQ(peaks[0], 1);
  EXPECT_EQ(peaks[1], 0.5f);
  EXPECT_EQ(peaks[2], 0.5f);
  EXPECT_EQ(peaks[3], 0);
  EXPECT_TRUE(peaksFrom({}).empty());
}

struct Damage {
  const char* name;
  void (*damage)(Bytes&);
  const char* says;
};

void PrintTo(const Damage& damage, std::ostream* out) {
  *out << damage.name;
}

const Damage kDamages[] = {
    {"Empty", [](Bytes& b) { b.clear(); }, "is no WAV file"},
    {"TornHeader", [](Bytes& b) { b.resize(11); }, "is no WAV file"},
    {"NotRiff", [](Bytes& b) { b[0] = 'J'; }, "is no WAV file"},
    {"NotWave", [](Bytes& b) { b[8] = 'A'; }, "is no WAV file"},
    {"OnlyHeader", [](Bytes& b) { b.resize(12); }, "holds no samples"},
    {"TornFormat", [](Bytes& b) { b.resize(30); }, "is cut off"},
    {"ShortFormat", [](Bytes& b) { put(b, 16, 8, 4); }, "format chunk that is too short"},
    {"HugeFormat", [](Bytes& b) { put(b, 16, 0xffffffff, 4); }, "is cut off"},
    {"EightBits", [](Bytes& b) { put(b, 34, 8, 2); }, "no 16-bit PCM"},
    {"TwentyFourBits", [](Bytes& b) { put(b, 34, 24, 2); }, "no 16-bit PCM"},
    {"Float", [](Bytes& b) { put(b, 20, 3, 2), put(b, 34, 32, 2); }, "no 16-bit PCM"},
    {"Compressed", [](Bytes& b) { put(b, 20, 17, 2); }, "no 16-bit PCM"},
    {"Stereo", [](Bytes& b) { put(b, 22, 2, 2); }, "has 2 channels"},
    {"NoChannel", [](Bytes& b) { put(b, 22, 0, 2); }, "has 0 channels"},
    {"NoRate", [](Bytes& b) { put(b, 24, 0, 4); }, "has 0 samples a second"},
    {"HugeRate", [](Bytes& b) { put(b, 24, 0xffffffff, 4); }, "has 4294967295 samples a second"},
    {"NoFormat", [](Bytes& b) { b[12] = 'x'; }, "samples before their format"},
    {"NoData", [](Bytes& b) { b[36] = 'x'; }, "holds no samples"},
    {"ZeroLength", [](Bytes& b) { put(b, 40, 0, 4); }, "holds no samples"},
    {"HalfASample", [](Bytes& b) { put(b, 40, 199, 4); }, "in the middle of a sample"},
    {"Truncated", [](Bytes& b) { b.resize(b.size() - 1); }, "is cut off"},
    {"HugeData", [](Bytes& b) { put(b, 40, 0xfffffffe, 4); }, "is cut off"},
    {"TornChunkHeader", [](Bytes& b) { b.resize(42); }, "holds no samples"},
};

class DamagedSound : public testing::TestWithParam<Damage> {};

TEST_P(DamagedSound, CostsOneSentenceAndThatSound) {
  const SoundFolder folder;
  Bytes bytes = soundFile();
  GetParam().damage(bytes);
  folder.write("bit", bytes);
  std::vector<std::string> sentences;
  const SoundBank bank = folder.load(sentences);
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find(folder.file("bit").string() + " "), std::string::npos) << sentences[0];
  EXPECT_NE(sentences[0].find(GetParam().says), std::string::npos) << sentences[0];
  EXPECT_NE(sentences[0].find("make_sounds.py"), std::string::npos) << sentences[0];
  for (uint32_t s = 0; s < kSounds; ++s) EXPECT_EQ(bank.effects[s].samples.empty(), Sound(s) == Sound::bit);
  EXPECT_FALSE(bank.music.samples.empty());
}

INSTANTIATE_TEST_SUITE_P(Each, DamagedSound, testing::ValuesIn(kDamages),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SoundFiles, AMissingOneAndAFolderInItsPlaceAreSaid) {
  const SoundFolder folder;
  fs::remove(folder.file("shot"));
  fs::remove(folder.file("music"));
  fs::create_directory(folder.file("music"));
  std::vector<std::string> sentences;
  const SoundBank bank = folder.load(sentences);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_NE(sentences[0].find(folder.file("shot").string() + " is missing"), std::string::npos);
  EXPECT_NE(sentences[1].find(folder.file("music").string() + " is no file"), std::string::npos);
  EXPECT_TRUE(bank.music.samples.empty());
}

TEST(SoundFiles, AMissingFolderIsOneSentence) {
  const SoundFolder folder;
  fs::remove_all(folder.path());
  std::vector<std::string> sentences;
  folder.load(sentences);
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find(folder.path().string()), std::string::npos);
}

TEST(SoundFiles, AHugeFileIsRefusedUnread) {
  const SoundFolder folder;
  fs::resize_file(folder.file("over"), uintmax_t(1) << 40);  // a hole: takes no room
  std::vector<std::string> sentences;
  folder.load(sentences);
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find("larger than 32 MiB"), std::string::npos) << sentences[0];
}

// Any bytes either parse into samples or are refused by a sentence.
RC_GTEST_PROP(SoundFiles, NoBytesCrash, ()) {
  Bytes bytes = soundFile();
  const auto edits =
      *rc::gen::container<std::vector<std::pair<uint8_t, uint8_t>>>(rc::gen::arbitrary<std::pair<uint8_t, uint8_t>>());
  for (const auto& [at, value] : edits) bytes[at % 64] = value;
  bytes.resize(*rc::gen::inRange<size_t>(0, bytes.size() + 1));
  try {
    const Clip clip = parseWav(bytes);
    RC_ASSERT(!clip.samples.empty() && clip.rate_hz >= 8000 && clip.rate_hz <= 96000);
  } catch (const std::runtime_error& problem) {
    RC_ASSERT(std::strlen(problem.what()) > 0);
  }
}

}  // namespace
}  // namespace gw::test
