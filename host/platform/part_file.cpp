#include "host/platform/part_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "host/platform/remedy.h"
#include "host/platform/replace_file.h"

namespace gw {

namespace fs = std::filesystem;

void refuseWriting(const fs::path& path, const std::string& why) {
  throw FileError(fmt::format("{} cannot be written: {}", path.string(), why));
}

fs::path writingDestination(const fs::path& path) {
  std::error_code error;
  if (path.empty()) refuseWriting("the file", "its name is empty; give a file name");
  const bool link = fs::is_symlink(fs::symlink_status(path, error));
  const fs::path target = link ? fs::weakly_canonical(path, error) : path;
  if (link && error) refuseWriting(path, because(error.value()));
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

namespace {

// Whose settings only he may read stay so, from the first byte of the new ones on. Owner before permissions: a change
// of owner may take some away.
void takeAfter(int part, const struct stat& old) {
  if (fchown(part, old.st_uid, old.st_gid) != 0) {
    (void)!fchown(part, uid_t(-1), old.st_gid);  // owners cannot be changed; the group may be, to one of the user's
  }
  fchmod(part, old.st_mode & 07777);
}

}  // namespace

OpenPart openPart(const fs::path& shown, const fs::path& target) {
  struct stat old {};
  const bool replaces = stat(target.c_str(), &old) == 0;
  OpenPart part;
  for (int attempt = 0; attempt < 100 && part.descriptor < 0; ++attempt) {
    part.name = fmt::format("{}.part-{}-{}", target.string(), getpid(), attempt);
    part.descriptor =
        open(part.name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, replaces ? mode_t(0600) : mode_t(0666));
    if (part.descriptor < 0 && errno != EEXIST) break;
  }
  if (part.descriptor < 0) refuseWriting(shown, because(errno));
  if (replaces) takeAfter(part.descriptor, old);
  // Held for as long as the descriptor is open, whatever ends the program: so a later one knows that this part is not
  // left over. A file system without locks shows it as left over; nothing else depends on it.
  flock(part.descriptor, LOCK_EX | LOCK_NB);
  return part;
}

void becomeTarget(OpenPart& part, const fs::path& shown, const fs::path& target, Sync sync) {
  if (sync == Sync::now && fsync(part.descriptor) != 0) refuseWriting(shown, because(errno));
  const int closed = close(std::exchange(part.descriptor, -1));
  if (closed != 0) refuseWriting(shown, because(errno));
  replaceFile(part.name, target, shown, sync);
}

PartFile::PartFile(const fs::path& path)
    : shown_(path), target_(writingDestination(path)), part_(openPart(shown_, target_)), unfinished_(part_.name) {}

PartFile::~PartFile() {
  if (part_.descriptor >= 0) close(part_.descriptor);
  unfinished_.keep();
  if (!part_.name.empty()) unlink(part_.name.c_str());
}

void PartFile::write(std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(part_.descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) refuseWriting(shown_, because(errno));
    bytes = bytes.subspan(size_t(written));
  }
}

void PartFile::become(Sync sync) {
  unfinished_.keep();  // it is whole, and may be all that there is while its bytes replace the target's
  becomeTarget(part_, shown_, target_, sync);
  part_.name.clear();
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
