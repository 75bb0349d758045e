#include "host/platform/atomic_file.h"

#include "host/platform/part_file.h"

namespace gw {

void checkWritable(const std::filesystem::path& path) {
  const PartFile part(path);
}

void writeFileAtomically(const std::filesystem::path& path, std::span<const uint8_t> bytes, Sync sync) {
  PartFile part(path);
  part.write(bytes);
  part.become(sync);
}

}  // namespace gw
