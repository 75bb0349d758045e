#include "host/platform/replace_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include "host/platform/part_file.h"
#include "host/platform/remedy.h"

namespace gw {
namespace {

namespace fs = std::filesystem;

// Makes the new name survive a power cut; some file systems cannot, and the file is whole either way.
void syncFolder(const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

bool keepsItsName(int error) {
  return error == EBUSY || error == EPERM || error == EACCES;
}

// Every byte of `from`, which has `length`, over those of `to`. The errno of what went wrong; 0: nothing.
int copyBytes(int from, int to, off_t length) {
  std::vector<uint8_t> block(1 << 16);
  for (off_t at = 0; at < length;) {
    const ssize_t got = pread(from, block.data(), block.size(), at);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return got < 0 ? errno : EIO;
    for (ssize_t done = 0; done < got;) {
      const ssize_t written = pwrite(to, block.data() + done, size_t(got - done), at + done);
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      done += written;
    }
    at += got;
  }
  if (ftruncate(to, length) != 0 || fsync(to) != 0) return errno;
  return 0;
}

// Where posix_fallocate() cannot reserve (some network file systems), writing tells.
int reserve(int file, off_t length) {
  if (length == 0) return 0;
  const int error = posix_fallocate(file, 0, length);
  return error == EOPNOTSUPP || error == EINVAL || error == ENODEV ? 0 : error;
}

void writeInPlace(std::string& part, const fs::path& target, const fs::path& shown) {
  const Descriptor from{open(part.c_str(), O_RDONLY | O_CLOEXEC)};
  struct stat facts {};
  if (from.number < 0 || fstat(from.number, &facts) != 0) refuseWriting(shown, because(errno));
  const Descriptor to{open(target.c_str(), O_WRONLY | O_CLOEXEC)};
  struct stat old {};
  if (to.number < 0 || fstat(to.number, &old) != 0) refuseWriting(shown, because(errno));
  if (const int error = reserve(to.number, facts.st_size); error != 0) {
    while (ftruncate(to.number, old.st_size) != 0 && errno == EINTR) {
    }
    refuseWriting(shown, because(error));
  }
  if (const int error = copyBytes(from.number, to.number, facts.st_size); error != 0) {
    const std::string whole = std::exchange(part, "");
    refuseWriting(shown, fmt::format("{}; what should stand there is in {}, whole", because(error), whole));
  }
  unlink(part.c_str());
}

}  // namespace

void replaceFile(std::string& part, const fs::path& target, const fs::path& shown, Sync sync) {
  if (rename(part.c_str(), target.c_str()) == 0) {
    if (sync == Sync::now) syncFolder(target);
  } else if (keepsItsName(errno)) {
    writeInPlace(part, target, shown);
  } else {
    refuseWriting(shown, because(errno));
  }
}

}  // namespace gw
