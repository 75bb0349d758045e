#include "tests/ptx_machine/ptx/fat_binary.h"

#include <cstring>

#include "tests/ptx_machine/ptx/ptx_module.h"

namespace gw::ptx {
namespace {

constexpr uint32_t kWrapperMagic = 0x466243B1, kMagic = 0xBA55ED50;
constexpr uint16_t kPtx = 1;

struct Wrapper {
  uint32_t magic, version;
  const void* data;
  const void* fatBinaries;
};

struct Header {
  uint32_t magic;
  uint16_t version, header_bytes;
  uint64_t bytes;
};

struct Entry {
  uint16_t kind, version;
  uint32_t header_bytes;
  uint64_t bytes;
  uint32_t compressed_bytes, optionsOffset_bytes;
  uint16_t minor, major;
  uint32_t architecture;
};

template <class T>
T read(std::string_view bytes, size_t at) {
  if (at + sizeof(T) > bytes.size()) throw PtxError("A fat binary ends in the middle of a header.");
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::string_view textOf(std::string_view padded) {
  return padded.substr(0, padded.find('\0'));
}

// Appends the PTX of the fat binary that begins at `at`, and returns where it ends.
size_t take(std::string_view all, size_t at, std::vector<EmbeddedPtx>& found) {
  const Header header = read<Header>(all, at);
  if (header.magic != kMagic) throw PtxError("This is no fat binary of CUDA: it begins with another number.");
  size_t next = at + header.header_bytes;
  if (header.bytes > all.size() - next) throw PtxError("A fat binary is shorter than its header says.");
  const size_t end = next + header.bytes;
  while (next < end) {
    const Entry entry = read<Entry>(all, next);
    if (entry.header_bytes < sizeof(Entry) || entry.header_bytes > end - next ||
        entry.bytes > end - next - entry.header_bytes) {
      throw PtxError("An entry of a fat binary is longer than the fat binary.");
    }
    if (entry.kind == kPtx) {
      const std::string_view text = textOf(all.substr(next + entry.header_bytes, entry.bytes));
      if (entry.compressed_bytes != 0 || text.find(".version") == std::string_view::npos) {
        throw PtxError("The PTX in a fat binary is compressed: compile with nvcc --no-compress.");
      }
      found.push_back({entry.architecture, text});
    }
    next += entry.header_bytes + entry.bytes;
  }
  return end;
}

}  // namespace

std::vector<EmbeddedPtx> embeddedPtx(const void* wrapper) {
  Wrapper w;
  std::memcpy(&w, wrapper, sizeof w);
  if (w.magic != kWrapperMagic) throw PtxError("What is registered is no wrapper of a fat binary.");
  Header header;
  std::memcpy(&header, w.data, sizeof header);
  std::vector<EmbeddedPtx> found;
  take({static_cast<const char*>(w.data), header.header_bytes + header.bytes}, 0, found);
  return found;
}

std::vector<EmbeddedPtx> embeddedPtxOfSection(std::string_view section) {
  std::vector<EmbeddedPtx> found;
  // Each begins at a multiple of 8, and zeros may stand between them.
  for (size_t at = 0; at + sizeof(Header) <= section.size();) {
    if (read<uint32_t>(section, at) == 0) {
      at += 8;
    } else {
      at = (take(section, at, found) + 7) / 8 * 8;
    }
  }
  return found;
}

}  // namespace gw::ptx
