#include "game/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace gw {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw FileError(fmt::format("{} cannot be written: {}", path.string(), why));
}

std::string because(int error, const char* remedy) {
  return fmt::format("{}; {}", std::strerror(error), remedy);
}

// Where the bytes really go: a link is followed, so that it goes on pointing at the file.
fs::path destination(const fs::path& path) {
  std::error_code error;
  if (path.empty()) refuse("the file", "its name is empty; give a file name");
  const bool link = fs::is_symlink(fs::symlink_status(path, error));
  const fs::path target = link ? fs::weakly_canonical(path, error) : path;
  if (link && error) refuse(path, because(error.value(), "choose another name"));
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) refuse(path, "it is a folder; give the name of a file in it");
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse(path, "it is not a plain file; choose another name");
  if (fs::exists(status) && faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
    refuse(path, "it is write-protected; choose another name or lift the protection");
  }
  return target;
}

// The temporary file: removed on destruction unless it became the real one.
class PartFile {
 public:
  PartFile(const fs::path& shown, fs::path target) : shown_(shown), target_(std::move(target)) {
    for (int attempt = 0; attempt < 100 && descriptor_ < 0; ++attempt) {
      name_ = fmt::format("{}.part-{}-{}", target_.string(), getpid(), attempt);
      descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (errno != EEXIST) break;
    }
    if (descriptor_ < 0) refuse(shown_, because(errno, "choose a folder that exists and that you may write to"));
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!renamed_) unlink(name_.c_str());
  }

  void write(std::span<const uint8_t> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) refuse(shown_, because(errno, "make room or choose another disk"));
      bytes = bytes.subspan(size_t(written));
    }
  }

  void become() {
    if (fsync(descriptor_) != 0) refuse(shown_, because(errno, "check the disk"));
    const int closed = close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) refuse(shown_, because(errno, "check the disk"));
    if (rename(name_.c_str(), target_.c_str()) != 0) refuse(shown_, because(errno, "choose another name"));
    renamed_ = true;
    syncFolder();
  }

 private:
  // Makes the new name survive a power cut; some file systems cannot, and the file is whole either way.
  void syncFolder() const {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
  }

  fs::path shown_, target_;
  std::string name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

void checkWritable(const fs::path& path) {
  PartFile(path, destination(path));
}

void writeFileAtomically(const fs::path& path, std::span<const uint8_t> bytes) {
  PartFile part(path, destination(path));
  part.write(bytes);
  part.become();
}

}  // namespace gw
