#include "game/replay/replay_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"

namespace gw {
namespace {

using namespace replay_format;
using Bytes = std::span<const uint8_t>;

constexpr const char* kFetchAgain = "copy or record it again";

// A chunk's name as text; what is no letter shows as '?'.
std::string chunkName(uint32_t kind) {
  std::string name;
  for (int i = 0; i < 4; ++i) {
    const char c = char(kind >> (8 * i));
    name += c >= 0x21 && c <= 0x7e ? c : '?';
  }
  return name;
}

struct Chunk {
  uint32_t kind, flags, firstTick;
  size_t offset;  // of its header, in the file
  Bytes payload;
};

class Decoder {
 public:
  Decoder(Bytes bytes, const std::string& name, SimulationVersions versions)
      : bytes_(bytes), name_(name), versions_(versions) {}

  Replay decode() {
    checkKind();
    readHeader();
    size_t offset = kHeaderBytes;
    for (uint32_t i = 0; i < chunks_; ++i) {
      const Chunk chunk = chunkAt(offset);
      offset += kChunkHeaderBytes + chunk.payload.size();
      if ((chunk.kind == kEndChunk) != (i + 1 == chunks_)) damaged("the END! chunk is not where the header says");
      readChunk(chunk);
    }
    if (offset != bytes_.size()) damaged(fmt::format("{} bytes follow its end", bytes_.size() - offset));
    checkComplete();
    return std::move(replay_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw ReplayError(fmt::format("{}: {}", name_, what)); }
  [[noreturn]] void damaged(const std::string& what) const {
    refuse(fmt::format("the replay is damaged ({}); {}", what, kFetchAgain));
  }

  template <std::unsigned_integral T>
  T header(size_t offset) const {
    return getLittle<T>(bytes_, offset);
  }

  // Tells empty, foreign and shortened files apart, since each has another remedy.
  void checkKind() const {
    if (bytes_.empty()) refuse(fmt::format("the file is empty; {}", kFetchAgain));
    if (bytes_.size() > kMaxFileBytes)
      refuse(
          fmt::format("the file is larger than {} MiB, which no replay is; name a "
                      "file that --record wrote",
                      kMaxFileBytes >> 20));
    const size_t compared = std::min(bytes_.size(), kMagic.size());
    if (!std::equal(kMagic.begin(), kMagic.begin() + compared, bytes_.begin())) {
      if (compared >= 4 && std::equal(kMagic.begin(), kMagic.begin() + 4, bytes_.begin())) {
        damaged("it was converted as if it were text");
      }
      const auto isText = [](uint8_t c) { return c >= 0x20 || c == '\n' || c == '\r' || c == '\t'; };
      const Bytes start = bytes_.first(std::min<size_t>(bytes_.size(), 512));
      refuse(fmt::format("this is {}, not a replay; name a file that --record wrote",
                         std::all_of(start.begin(), start.end(), isText) ? "a text file" : "a file of another kind"));
    }
    if (bytes_.size() < kHeaderBytes) damaged("it ends within its header");
  }

  void readHeader() {
    const uint16_t major = header<uint16_t>(kOffsetMajor), minor = header<uint16_t>(kOffsetMinor);
    if (major > kReplayMajor) {
      refuse(fmt::format("the replay has format {}.{}, newer than this program's {}.{}; use a newer GpuWars", major,
                         minor, kReplayMajor, kReplayMinor));
    }
    if (header<uint64_t>(kOffsetChecksum) != replayChecksum(bytes_.first(kOffsetChecksum))) {
      damaged("the checksum of its header differs");
    }
    if (major < kReplayMajor) refuse(fmt::format("format {}.{} was never released; record it again", major, minor));
    if (header<uint32_t>(kOffsetHeaderBytes) != kHeaderBytes) damaged("its header has another length");

    ReplayHeader& head = replay_.header;
    head.simulationVersion = header<uint32_t>(kOffsetSimulationVersion);
    if (versions_ == SimulationVersions::current && head.simulationVersion != kSimulationVersion) {
      refuse(
          fmt::format("the replay was recorded by simulation version {}, and this program plays version {}; bring it "
                      "up to date with tests/update_replays, or use the build that recorded it",
                      head.simulationVersion, kSimulationVersion));
    }
    head.seed = header<uint64_t>(kOffsetSeed);
    head.mode = Mode(header<uint32_t>(kOffsetMode));
    head.enemies = header<uint32_t>(kOffsetEnemies);
    head.autopilot = Autopilot(header<uint32_t>(kOffsetAutopilot));
    ticks_ = header<uint32_t>(kOffsetTicks);
    chunks_ = header<uint32_t>(kOffsetChunks);
    head.gather = Gather(header<uint32_t>(kOffsetGather));
    head.sort = Sort(header<uint32_t>(kOffsetSort));
    if (head.mode > Mode::practice) damaged("its mode is unknown");
    if (head.enemies < 1 || head.enemies > kMaxEnemies) damaged("its number of enemies is out of range");
    if (head.autopilot > Autopilot::expert) damaged("its autopilot is unknown");
    if (head.gather > Gather::fixed) damaged("its gather is unknown");
    if (head.sort > Sort::oddEven) damaged("its sort is unknown");
    if (head.gather == Gather::exact && head.sort != Sort::bitonic) damaged("its gather and sort do not go together");
    // Every tick takes a hash and every chunk a header: more cannot be in the file, so nothing that is
    // counted here can make the reader allocate much more than the file's own size.
    if (ticks_ < 1 || ticks_ > kMaxTicks || ticks_ > bytes_.size() / kHashBytes)
      damaged("its number of ticks is out of range");
    if (chunks_ < 1 || chunks_ > bytes_.size() / kChunkHeaderBytes) damaged("its number of chunks is out of range");
  }

  Chunk chunkAt(size_t offset) const {
    const size_t left = bytes_.size() - offset;
    if (left < kChunkHeaderBytes) damaged("it ends before its END! chunk");
    const uint32_t kind = header<uint32_t>(offset), flags = header<uint32_t>(offset + 4);
    const uint32_t length = header<uint32_t>(offset + 8), firstTick = header<uint32_t>(offset + 12);
    const std::string chunk = chunkName(kind);
    if (length > kMaxChunkBytes) damaged(fmt::format("chunk {} claims more than {} bytes", chunk, kMaxChunkBytes));
    if (length > left - kChunkHeaderBytes) damaged(fmt::format("it ends within chunk {}", chunk));
    if (flags & ~kRequired) damaged(fmt::format("chunk {} has unknown flags", chunk));
    const Bytes payload = bytes_.subspan(offset + kChunkHeaderBytes, length);
    if (header<uint64_t>(offset + 16) != replayChecksum(payload)) {
      damaged(fmt::format("the checksum of chunk {} differs", chunk));
    }
    return {kind, flags, firstTick, offset, payload};
  }

  void readChunk(const Chunk& chunk) {
    switch (chunk.kind) {
      case kOptionsChunk:
        return readOptions(chunk);
      case kTablesChunk:
        return readTables(chunk);
      case kInputsChunk:
        return readInputs(chunk);
      case kHashesChunk:
        return readHashes(chunk);
      case kFinalChunk:
        return readFinal(chunk);
      case kEndChunk:
        return readEnd(chunk);
      default:
        if (chunk.flags & kRequired) {
          refuse(fmt::format("the replay needs chunk {}, which this program does not know; use a newer GpuWars",
                             chunkName(chunk.kind)));
        }
    }
  }

  // Chunks of which a file holds one.
  void once(const Chunk& chunk, bool& seen, uint32_t flags) const {
    if (seen) damaged(fmt::format("chunk {} stands in it twice", chunkName(chunk.kind)));
    if (chunk.flags != flags || chunk.firstTick != 0)
      damaged(fmt::format("chunk {} is mislabelled", chunkName(chunk.kind)));
    seen = true;
  }

  // Chunks that together hold every tick in order.
  void continues(const Chunk& chunk, size_t ticksSoFar, size_t itemBytes) const {
    const std::string name = chunkName(chunk.kind);
    if (chunk.flags != kRequired) damaged(fmt::format("chunk {} is mislabelled", name));
    if (chunk.payload.empty() || chunk.payload.size() % itemBytes)
      damaged(fmt::format("chunk {} has a broken length", name));
    if (chunk.firstTick != ticksSoFar + 1) damaged(fmt::format("chunk {} does not continue the one before", name));
  }

  void readOptions(const Chunk& chunk) {
    once(chunk, haveOptions_, 0);
    if (chunk.payload.size() > kMaxOptionsBytes) damaged("its options text is too long");
    replay_.header.options.assign(chunk.payload.begin(), chunk.payload.end());
  }

  void readTables(const Chunk& chunk) {
    once(chunk, haveTables_, kRequired);
    size_t offset = 0;
    const auto next = [&](RuleText& text, const char* file) {
      const size_t left = chunk.payload.size() - offset;
      if (left < 4) damaged("its rule tables end early");
      const uint32_t length = getLittle<uint32_t>(chunk.payload, offset);
      if (length > left - 4 || length > kMaxRuleText) damaged("a rule table is longer than its chunk");
      const Bytes bytes = chunk.payload.subspan(offset + 4, length);
      text = {fmt::format("{} in {}", file, name_), std::string(bytes.begin(), bytes.end())};
      offset += 4 + length;
    };
    next(replay_.rules.game, "game.toml");
    next(replay_.rules.enemies, "enemies.toml");
    next(replay_.rules.waves, "waves.toml");
    if (offset != chunk.payload.size()) damaged("its rule tables are followed by something else");
  }

  void readInputs(const Chunk& chunk) {
    continues(chunk, replay_.inputs.size(), kRunBytes);
    for (size_t at = 0; at < chunk.payload.size(); at += kRunBytes) {
      const uint32_t length = getLittle<uint32_t>(chunk.payload, at);
      if (length < 1 || length > ticks_ - replay_.inputs.size()) damaged("it has more inputs than ticks");
      InputRecord input;
      input.move_x = int16_t(getLittle<uint16_t>(chunk.payload, at + 4));
      input.move_y = int16_t(getLittle<uint16_t>(chunk.payload, at + 6));
      input.aim = getLittle<uint16_t>(chunk.payload, at + 8);
      input.buttons = getLittle<uint16_t>(chunk.payload, at + 10);
      if (input.move_x < -kStickFull || input.move_y < -kStickFull || (input.buttons & ~kButtonsKnown)) {
        damaged("an input is out of range");
      }
      replay_.inputs.insert(replay_.inputs.end(), length, input);
    }
  }

  void readHashes(const Chunk& chunk) {
    continues(chunk, replay_.hashes.size(), kHashBytes);
    const size_t count = chunk.payload.size() / kHashBytes;
    if (count > ticks_ - replay_.hashes.size()) damaged("it has more hashes than ticks");
    for (size_t i = 0; i < count; ++i) replay_.hashes.push_back(getLittle<uint64_t>(chunk.payload, i * kHashBytes));
  }

  void readFinal(const Chunk& chunk) {
    once(chunk, haveFinal_, kRequired);
    if (chunk.payload.size() != kFinalBytes) damaged("its final report has another length");
    const uint32_t over = getLittle<uint32_t>(chunk.payload, 20);
    if (over > 1) damaged("its final report is out of range");
    replay_.result = {getLittle<uint64_t>(chunk.payload, 0), getLittle<uint64_t>(chunk.payload, 8),
                      getLittle<uint32_t>(chunk.payload, 16), over == 1};
  }

  void readEnd(const Chunk& chunk) {
    once(chunk, haveEnd_, kRequired);
    if (chunk.payload.size() != kEndBytes) damaged("its END! chunk has another length");
    if (getLittle<uint64_t>(chunk.payload, 0) != replayChecksum(bytes_.first(chunk.offset))) {
      damaged("the checksum of the whole file differs");
    }
  }

  void checkComplete() const {
    if (!haveTables_) damaged("its rule tables are missing");
    if (!haveFinal_) damaged("its final report is missing");
    if (replay_.inputs.size() != ticks_) damaged("inputs are missing");
    if (replay_.hashes.size() != ticks_) damaged("hashes are missing");
  }

  Bytes bytes_;
  const std::string& name_;
  SimulationVersions versions_;
  Replay replay_;
  uint32_t ticks_ = 0, chunks_ = 0;
  bool haveOptions_ = false, haveTables_ = false, haveFinal_ = false, haveEnd_ = false;
};

}  // namespace

Replay decodeReplay(std::span<const uint8_t> bytes, const std::string& name, SimulationVersions versions) {
  return Decoder(bytes, name, versions).decode();
}

Replay readReplay(const std::filesystem::path& path, SimulationVersions versions) {
  namespace fs = std::filesystem;
  const std::string name = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw ReplayError(fmt::format("{}: there is no such file; check its name", name));
  if (!fs::is_regular_file(status)) {
    throw ReplayError(fmt::format("{}: this is not a plain file; name a file that --record wrote", name));
  }
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? std::streamoff(file.tellg()) : -1;
  if (size < 0) {
    throw ReplayError(fmt::format("{}: the file cannot be read ({}); give yourself the right to read it", name,
                                  std::strerror(errno)));
  }
  // One byte past the limit is enough to see that a file is too large.
  std::vector<uint8_t> bytes(std::min<uint64_t>(uint64_t(size), kMaxFileBytes + 1));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
  if (size_t(file.gcount()) != bytes.size()) {
    throw ReplayError(fmt::format("{}: reading failed; check the disk or copy the file again", name));
  }
  return decodeReplay(bytes, name, versions);
}

}  // namespace gw
