#include "game/commands/hash_file.h"

#include <cerrno>
#include <cinttypes>
#include <cstring>

#include "host/platform/user_error.h"

namespace gw {

HashFile::HashFile(const std::filesystem::path& path) : path_(path) {
  if (path.empty()) return;
  owner_.reset(path == "-" ? stdout : std::fopen(path.c_str(), "w"));
  file_ = owner_.get();
  if (file_ == nullptr) {
    throw UserError(ExitCode::badFile, "Cannot write " + path.string() + " (" + std::strerror(errno) +
                                           "): choose another place with --hashes.");
  }
}

void HashFile::write(uint32_t tick, uint64_t hash) {
  if (file_ != nullptr) std::fprintf(file_, "%" PRIu32 " %016" PRIx64 "\n", tick, hash);
}

void HashFile::comment(const std::string& text) {
  if (file_ != nullptr) std::fprintf(file_, "# %s\n", text.c_str());
}

void HashFile::close() {
  if (file_ == nullptr) return;
  const bool good = std::fflush(file_) == 0 && std::ferror(file_) == 0;
  file_ = nullptr;
  owner_.reset();
  if (!good) {
    throw UserError(ExitCode::badFile, "Cannot write " + path_.string() + " to its end: make room on the disk.");
  }
}

}  // namespace gw
