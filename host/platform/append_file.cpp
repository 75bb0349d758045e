#include "host/platform/append_file.h"

#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace gw {

AppendFile::AppendFile(const std::filesystem::path& path)
    : shown_(path), target_(writingDestination(path)), part_(openPart(shown_, target_)) {}

AppendFile::~AppendFile() {
  if (part_.descriptor >= 0) close(part_.descriptor);
}

bool AppendFile::append(std::span<const uint8_t> bytes) {
  if (part_.descriptor < 0) return false;
  for (size_t done = 0; done < bytes.size();) {
    const ssize_t written = pwrite(part_.descriptor, bytes.data() + done, bytes.size() - done, off_t(length_ + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      // What does not fit is taken back; if even that fails the next try writes over it.
      while (ftruncate(part_.descriptor, off_t(length_)) != 0 && errno == EINTR) {
      }
      return false;
    }
    done += size_t(written);
  }
  length_ += bytes.size();
  return true;
}

void AppendFile::remove() {
  if (part_.name.empty()) return;
  unlink(part_.name.c_str());
  part_.name.clear();
  if (part_.descriptor >= 0) close(std::exchange(part_.descriptor, -1));
}

void AppendFile::become() {
  becomeTarget(part_, shown_, target_);
  part_.name.clear();
}

}  // namespace gw
