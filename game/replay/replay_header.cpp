#include "game/replay/replay_header.h"

#include <algorithm>

#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"

namespace gw {
namespace {

using namespace replay_format;
using Bytes = std::span<const uint8_t>;

void checkKind(Bytes file, const ReplayRefusal& refusal) {
  if (file.empty()) refusal.refuse(fmt::format("the file is empty; {}", ReplayRefusal::kFetchAgain));
  refuseTooLarge(file.size(), refusal);
  const size_t compared = std::min(file.size(), kMagic.size());
  if (!std::equal(kMagic.begin(), kMagic.begin() + compared, file.begin())) {
    if (compared >= 4 && std::equal(kMagic.begin(), kMagic.begin() + 4, file.begin())) {
      refusal.damaged("it was converted as if it were text");
    }
    const auto isText = [](uint8_t c) { return c >= 0x20 || c == '\n' || c == '\r' || c == '\t'; };
    const Bytes start = file.first(std::min<size_t>(file.size(), 512));
    refusal.refuse(
        fmt::format("this is {}, not a replay; name a file that --record wrote",
                    std::all_of(start.begin(), start.end(), isText) ? "a text file" : "a file of another kind"));
  }
  if (file.size() < kHeaderBytes) refusal.damaged("it ends within its header");
}

uint16_t majorOf(Bytes file, const ReplayRefusal& refusal) {
  const uint16_t major = getLittle<uint16_t>(file, kOffsetMajor), minor = getLittle<uint16_t>(file, kOffsetMinor);
  if (major > kReplayMajor) {
    refusal.refuse(fmt::format("the replay has format {}.{}, newer than this program's {}.{}; use a newer GpuWars",
                               major, minor, kReplayMajor, kReplayMinor));
  }
  if (getLittle<uint64_t>(file, kOffsetChecksum) != replayChecksum(file.first(kOffsetChecksum))) {
    refusal.damaged("the checksum of its header differs");
  }
  if (major == 0) refusal.refuse(fmt::format("format {}.{} was never released; record it again", major, minor));
  if (getLittle<uint32_t>(file, kOffsetHeaderBytes) != kHeaderBytes) refusal.damaged("its header has another length");
  return major;
}

// A count says what to expect, not what to allocate; the file may have been cut since.
void checkCounts(const ReplayFileHeader& header, const ReplayRefusal& refusal) {
  if (header.major >= 2 && header.growing()) return;
  if (header.ticks < 1 || header.ticks > kMaxTicks) refusal.damaged("its number of ticks is out of range");
  if (header.chunks < 1 || header.chunks > kMaxFileBytes / kChunkHeaderBytes1) {
    refusal.damaged("its number of chunks is out of range");
  }
}

}  // namespace

void refuseTooLarge(uint64_t bytes, const ReplayRefusal& refusal) {
  if (bytes <= kMaxFileBytes) return;
  refusal.refuse(fmt::format("the file is larger than {} MiB, which no replay is; name a file that --record wrote",
                             kMaxFileBytes >> 20));
}

ReplayFileHeader readReplayHeader(Bytes file, const ReplayRefusal& refusal, SimulationVersions versions) {
  checkKind(file, refusal);
  ReplayFileHeader header;
  header.major = majorOf(file, refusal);
  const auto number = [&](size_t offset) { return getLittle<uint32_t>(file, offset); };
  ReplayHeader& run = header.run;
  run.simulationVersion = number(kOffsetSimulationVersion);
  if (versions == SimulationVersions::current && run.simulationVersion != kSimulationVersion) {
    refusal.refuse(
        fmt::format("the replay was recorded by simulation version {}, and this program plays version {}; bring it "
                    "up to date with tests/update_replays, or use the build that recorded it",
                    run.simulationVersion, kSimulationVersion));
  }
  run.seed = getLittle<uint64_t>(file, kOffsetSeed);
  run.mode = Mode(number(kOffsetMode));
  run.enemies = number(kOffsetEnemies);
  run.autopilot = Autopilot(number(kOffsetAutopilot));
  run.gather = Gather(number(kOffsetGather));
  run.sort = Sort(number(kOffsetSort));
  header.ticks = number(kOffsetTicks);
  header.chunks = number(kOffsetChunks);
  if (run.mode > Mode::practice) refusal.damaged("its mode is unknown");
  if (run.enemies < 1 || run.enemies > kMaxEnemies) refusal.damaged("its number of enemies is out of range");
  if (run.autopilot > Autopilot::expert) refusal.damaged("its autopilot is unknown");
  if (run.gather > Gather::fixed) refusal.damaged("its gather is unknown");
  if (run.sort > Sort::oddEven) refusal.damaged("its sort is unknown");
  if (run.gather == Gather::exact && run.sort != Sort::bitonic) {
    refusal.damaged("its gather and sort do not go together");
  }
  checkCounts(header, refusal);
  return header;
}

}  // namespace gw
