#include "host/video/mp4_check.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <system_error>

namespace gw {
namespace {

uint64_t bigEndian(const uint8_t* bytes, size_t count) {
  uint64_t value = 0;
  for (size_t i = 0; i < count; ++i) value = value << 8 | bytes[i];
  return value;
}

}  // namespace

// A box: its length in 4 bytes, its kind in 4, a longer length in 8 more where the first says 1 (ISO/IEC
// 14496-12, 4.2).
bool isWholeMp4(const std::filesystem::path& path) {
  std::error_code error;
  const uint64_t length = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) return false;
  bool index = false, pictures = false;
  for (uint64_t at = 0; at < length;) {
    uint8_t head[16];
    file.seekg(std::streamoff(at));
    if (!file.read(reinterpret_cast<char*>(head), 8)) return false;
    const std::string kind(reinterpret_cast<const char*>(head) + 4, 4);
    uint64_t size = bigEndian(head, 4), least = 8;
    if (size == 1) {
      if (!file.read(reinterpret_cast<char*>(head) + 8, 8)) return false;
      size = bigEndian(head + 8, 8);
      least = 16;
    }
    if (size == 0) size = length - at;  // to the end of the file
    if (size < least || size > length - at || (at == 0 && kind != "ftyp")) return false;
    index = index || kind == "moov";
    pictures = pictures || (kind == "mdat" && size > least);
    at += size;
  }
  return index && pictures;
}

}  // namespace gw
