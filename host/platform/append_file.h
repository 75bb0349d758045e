// A file that grows beside its target while something goes on, and that is still there when the program dies.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "host/platform/part_file.h"

namespace gw {

class AppendFile {
 public:
  // Makes TARGET.part-PID-N. Throws FileError about `path` when it cannot.
  explicit AppendFile(const std::filesystem::path& path);
  // The file stays, as a killed program leaves it; remove() deletes it.
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  // Hands the bytes to the system, all or none; false when the disk takes no more, and the same bytes may be tried
  // again later. They outlive the program from then on. Nothing is synced to the disk, which would stall a tick: a
  // power cut may lose what the system had not written back yet. Never allocates.
  bool append(std::span<const uint8_t> bytes);

  void remove();
  // Syncs it and gives it the name of the target. Throws FileError; the file is then still there.
  void become();

  std::filesystem::path path() const { return part_.name; }

 private:
  std::filesystem::path shown_, target_;
  OpenPart part_;
  uint64_t length_ = 0;  // that was appended whole
};

}  // namespace gw
