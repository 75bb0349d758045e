#include "game/files/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <utility>

#include "game/files/part_file.h"

namespace gw {
namespace {

namespace fs = std::filesystem;

// The temporary file: removed on destruction unless it became the real one.
class PartFile {
 public:
  PartFile(const fs::path& shown, fs::path target)
      : shown_(shown), target_(std::move(target)), part_(openPart(shown_, target_)) {}
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile() {
    if (part_.descriptor >= 0) close(part_.descriptor);
    if (!renamed_) unlink(part_.name.c_str());
  }

  void write(std::span<const uint8_t> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(part_.descriptor, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) refuseWriting(shown_, because(errno, "make room or choose another disk"));
      bytes = bytes.subspan(size_t(written));
    }
  }

  void become() {
    becomeTarget(part_, shown_, target_);
    renamed_ = true;
  }

 private:
  fs::path shown_, target_;
  OpenPart part_;
  bool renamed_ = false;
};

}  // namespace

void checkWritable(const fs::path& path) {
  PartFile(path, writingDestination(path));
}

void writeFileAtomically(const fs::path& path, std::span<const uint8_t> bytes) {
  PartFile part(path, writingDestination(path));
  part.write(bytes);
  part.become();
}

}  // namespace gw
