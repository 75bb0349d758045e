#include "tests/game/replay_samples.h"

#include <algorithm>
#include <stdexcept>

#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"
#include "game/replay/replay_reader.h"

namespace gw::test {

using namespace replay_format;

Replay sampleReplay() {
  Replay replay;
  replay.header = {0x0123456789abcdef, Mode::arcade,          8192,          Autopilot::novice,
                   kSimulationVersion, "--seed 7 --headless", Gather::fixed, Sort::oddEven};
  replay.rules = {{"g", "a = 1\n"}, {"e", ""}, {"w", "# waves\n"}};
  const InputRecord still{}, right{kStickFull, 0, 0, kButtonFire}, down{-5, -kStickFull, 65535, kButtonsKnown};
  replay.inputs = {still, still, right, right, right, down, still, right, right, right, right, right};
  for (size_t i = 0; i < replay.inputs.size(); ++i) replay.hashes.push_back(0x9e3779b97f4a7c15 * (i + 1));
  replay.result = {123456789012345, 42, 83334, true};
  return replay;
}

std::string refusalOf(const Bytes& bytes) {
  try {
    decodeReplay(bytes, "x.gwr");
    return "";
  } catch (const ReplayError& error) {
    return error.what();
  }
}

ForgedFile::ForgedFile(const Bytes& file) : header(file.begin(), file.begin() + kHeaderBytes) {
  for (size_t at = kHeaderBytes; at < file.size();) {
    const uint32_t length = getLittle<uint32_t>(file, at + 8);
    const auto payload = file.begin() + ptrdiff_t(at + kChunkHeaderBytes);
    chunks.push_back({getLittle<uint32_t>(file, at), getLittle<uint32_t>(file, at + 4),
                      getLittle<uint32_t>(file, at + 12), Bytes(payload, payload + length), length});
    at += kChunkHeaderBytes + length;
  }
  chunks.pop_back();
}

ForgedChunk& ForgedFile::chunk(uint32_t kind) {
  for (ForgedChunk& c : chunks) {
    if (c.kind == kind) return c;
  }
  throw std::logic_error("no such chunk");
}

void ForgedFile::setHeader16(size_t offset, uint16_t value) {
  putLittleAt(header, offset, value);
}
void ForgedFile::setHeader32(size_t offset, uint32_t value) {
  putLittleAt(header, offset, value);
}

Bytes ForgedFile::seal(bool countChunks) const {
  Bytes file = header;
  if (countChunks) putLittleAt(file, kOffsetChunks, uint32_t(chunks.size() + 1));
  putLittleAt(file, kOffsetChecksum, replayChecksum(std::span(file).first(kOffsetChecksum)));
  const auto add = [&](const ForgedChunk& c) {
    putLittle(file, c.kind);
    putLittle(file, c.flags);
    putLittle(file, c.claimedLength);
    putLittle(file, c.firstTick);
    putLittle(file, replayChecksum(c.payload));
    file.insert(file.end(), c.payload.begin(), c.payload.end());
  };
  for (const ForgedChunk& c : chunks) add(c);
  Bytes end;
  putLittle(end, replayChecksum(file));
  add({kEndChunk, kRequired, 0, end, uint32_t(end.size())});
  return file;
}

}  // namespace gw::test
