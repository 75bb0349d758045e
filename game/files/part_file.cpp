#include "game/files/part_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "game/files/atomic_file.h"

namespace gw {

namespace fs = std::filesystem;

void refuseWriting(const fs::path& path, const std::string& why) {
  throw FileError(fmt::format("{} cannot be written: {}", path.string(), why));
}

std::string because(int error, const char* remedy) {
  return fmt::format("{}; {}", std::strerror(error), remedy);
}

fs::path writingDestination(const fs::path& path) {
  std::error_code error;
  if (path.empty()) refuseWriting("the file", "its name is empty; give a file name");
  const bool link = fs::is_symlink(fs::symlink_status(path, error));
  const fs::path target = link ? fs::weakly_canonical(path, error) : path;
  if (link && error) refuseWriting(path, because(error.value(), "choose another name"));
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) refuseWriting(path, "it is a folder; give the name of a file in it");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    refuseWriting(path, "it is not a plain file; choose another name");
  }
  if (fs::exists(status) && faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
    refuseWriting(path, "it is write-protected; choose another name or lift the protection");
  }
  return target;
}

OpenPart openPart(const fs::path& shown, const fs::path& target) {
  OpenPart part;
  for (int attempt = 0; attempt < 100 && part.descriptor < 0; ++attempt) {
    part.name = fmt::format("{}.part-{}-{}", target.string(), getpid(), attempt);
    part.descriptor = open(part.name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (part.descriptor < 0 && errno != EEXIST) break;
  }
  if (part.descriptor < 0) {
    refuseWriting(shown, because(errno, "choose a folder that exists and that you may write to"));
  }
  // Held for as long as the descriptor is open, whatever ends the program: so a later one knows that this part is not
  // left over. A file system without locks shows it as left over; nothing else depends on it.
  flock(part.descriptor, LOCK_EX | LOCK_NB);
  return part;
}

namespace {

// Makes the new name survive a power cut; some file systems cannot, and the file is whole either way.
void syncFolder(const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

}  // namespace

void becomeTarget(OpenPart& part, const fs::path& shown, const fs::path& target) {
  if (fsync(part.descriptor) != 0) refuseWriting(shown, because(errno, "check the disk"));
  const int closed = close(std::exchange(part.descriptor, -1));
  if (closed != 0) refuseWriting(shown, because(errno, "check the disk"));
  if (rename(part.name.c_str(), target.c_str()) != 0) refuseWriting(shown, because(errno, "choose another name"));
  syncFolder(target);
}

bool isBeingWritten(const fs::path& part) {
  const int descriptor = open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return false;
  const bool locked = flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(descriptor);
  return locked;
}

std::vector<fs::path> partsLeftBeside(const fs::path& path) {
  const fs::path target = writingDestination(path);
  const std::string prefix = target.filename().string() + ".part-";
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (!at->path().filename().string().starts_with(prefix) || !at->is_regular_file(error)) continue;
    const fs::path part = target.has_parent_path() ? at->path() : at->path().filename();
    if (!isBeingWritten(part)) found.push_back(part);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace gw
