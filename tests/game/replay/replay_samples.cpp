#include "tests/game/replay/replay_samples.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "game/replay/byte_order.h"
#include "game/replay/checksum.h"
#include "game/replay/chunk_frames.h"
#include "game/replay/recorder.h"
#include "game/replay/replay_reader.h"
#include "game/replay/replay_writer.h"

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

Replay longerReplay() {
  Replay replay = sampleReplay();
  replay.header.options.assign(80, '-');
  replay.rules.enemies.text = std::string(40, '#') + "\n";
  while (replay.inputs.size() < 150) {
    const size_t i = replay.inputs.size();
    replay.inputs.push_back(i < 40 ? InputRecord{int16_t(i), 0, uint16_t(7 * i), 0} : replay.inputs[i - 30]);
    replay.hashes.push_back(0x9e3779b97f4a7c15 * (i + 1));
  }
  for (uint64_t k = 0; k < replay.inputs.size() / kFieldHashesEvery_ticks; ++k) {
    FieldHashes& fields = replay.fieldHashes.emplace_back();
    for (uint64_t field = 0; field < kHashFields; ++field) fields[field] = 0xbf58476d1ce4e5b9 * (100 * k + field + 1);
  }
  return replay;
}

Bytes format1(const Replay& replay) {
  ForgedFile file(encodeReplay(replay));
  file.setHeader16(kOffsetMajor, 1);
  file.setHeader16(kOffsetMinor, 1);
  std::erase_if(file.chunks, [](const ForgedChunk& c) { return c.kind == kFieldHashesChunk; });
  for (ForgedChunk& c : file.chunks) c.stored.reset();
  return file.seal();
}

Bytes growingFile(const Replay& replay) {
  char folder[] = "/tmp/gw_growing_XXXXXX";
  if (!mkdtemp(folder)) throw std::runtime_error("no temporary folder");
  Bytes file;
  {
    Recorder recorder(std::filesystem::path(folder) / "run.gwr", replay.header, replay.rules);
    for (size_t i = 0; i < replay.inputs.size(); ++i) recorder.append(reportOf(replay, i));
    std::ifstream stream(std::filesystem::directory_iterator(folder)->path(), std::ios::binary);
    file.assign(std::istreambuf_iterator<char>(stream), {});
    recorder.abandon();
  }
  std::filesystem::remove_all(folder);
  return file;
}

TickReport reportOf(const Replay& replay, size_t index) {
  TickReport report;
  report.tick = uint32_t(index + 1);
  report.input = replay.inputs[index];
  report.hash = replay.hashes[index];
  const size_t fields = (index + 1) / kFieldHashesEvery_ticks;
  if (report.tick % kFieldHashesEvery_ticks == 0 && fields <= replay.fieldHashes.size()) {
    std::copy_n(replay.fieldHashes[fields - 1].begin(), kHashFields, report.fieldHashes);
  }
  return report;
}

bool sameContent(const Replay& a, const Replay& b) {
  return a.header == b.header && a.inputs == b.inputs && a.hashes == b.hashes && a.result == b.result &&
         a.fieldHashes == b.fieldHashes && a.rules.game.text == b.rules.game.text &&
         a.rules.enemies.text == b.rules.enemies.text && a.rules.waves.text == b.rules.waves.text;
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
  const ReplayRefusal refusal("forged");
  ChunkFrames frames(file, getLittle<uint16_t>(file, kOffsetMajor), refusal);
  while (const std::optional<Chunk> chunk = frames.next()) {
    if (chunk->kind == kEndChunk) break;
    const auto payload = frames.payload(*chunk);
    ForgedChunk& c = chunks.emplace_back();
    c = {chunk->kind, chunk->flags, chunk->firstTick, Bytes(payload.begin(), payload.end()), uint32_t(chunk->rawBytes)};
    if (chunk->stored.size() < chunk->rawBytes) c.stored = Bytes(chunk->stored.begin(), chunk->stored.end());
  }
}

ForgedChunk& ForgedFile::chunk(uint32_t kind) {
  for (ForgedChunk& c : chunks) {
    if (c.kind == kind) {
      c.stored.reset();
      return c;
    }
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
  const auto add = [&](const ForgedChunk& c) { putForged(file, c); };
  for (const ForgedChunk& c : chunks) add(c);
  Bytes end;
  putLittle(end, replayChecksum(file));
  add({kEndChunk, kRequired, 0, end, uint32_t(end.size())});
  return file;
}

std::vector<size_t> ForgedFile::ends() const {
  std::vector<size_t> ends;
  Bytes file = header;
  for (const ForgedChunk& c : chunks) {
    putForged(file, c);
    ends.push_back(file.size());
  }
  return ends;
}

void ForgedFile::putForged(Bytes& file, const ForgedChunk& c) const {
  const Bytes& stored = c.stored ? *c.stored : c.payload;
  putLittle(file, c.kind);
  putLittle(file, c.flags);
  putLittle(file, c.claimedLength);
  if (getLittle<uint16_t>(header, kOffsetMajor) == 1) {
    putLittle(file, c.firstTick);
  } else {
    putLittle(file, c.claimedStored.value_or(c.stored ? uint32_t(stored.size()) : c.claimedLength));
    putLittle(file, c.firstTick);
    putLittle(file, uint32_t(0));
  }
  putLittle(file, replayChecksum(stored));
  file.insert(file.end(), stored.begin(), stored.end());
}

}  // namespace gw::test
