#include "host/platform/remedy.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace gw {
namespace {

constexpr const char* kRoom = "make room or choose another disk";
constexpr const char* kFolder = "choose a folder that exists";
constexpr const char* kRights = "choose a folder that you may write to";
constexpr const char* kName = "choose another name";

struct Remedy {
  int error;
  const char* words;  // in English, as programs write them that do not translate; null: no other program is asked
  const char* remedy;
};

constexpr Remedy kRemedies[] = {
    {ENOSPC, "No space left on device", kRoom},
    {EDQUOT, "Disk quota exceeded", kRoom},
    {EFBIG, "File too large", kRoom},
    {ENOENT, "No such file or directory", kFolder},
    {ENOTDIR, "Not a directory", kFolder},
    {EACCES, "Permission denied", kRights},
    {EPERM, "Operation not permitted", kRights},
    {EROFS, "Read-only file system", kRights},
    {EIO, "Input/output error", "check the disk"},
    {ENAMETOOLONG, nullptr, kName},
    {EINVAL, nullptr, kName},
    {EILSEQ, nullptr, kName},
    {ELOOP, nullptr, kName},
    {ETXTBSY, nullptr, kName},
    {EMFILE, nullptr, "close files or raise the limit of open ones (ulimit -n)"},
    {ENFILE, nullptr, "close other programs"},
};

}  // namespace

const char* remedyFor(int error) {
  for (const Remedy& known : kRemedies) {
    if (known.error == error) return known.remedy;
  }
  return "choose another folder";
}

std::string because(int error) {
  return fmt::format("{}; {}", std::strerror(error), remedyFor(error));
}

std::string becauseNoFolder(int error) {
  if (error != ENOENT && error != ENOTDIR) return because(error);
  return fmt::format("{}; choose a folder inside one that exists", std::strerror(error));
}

int errorNamedIn(std::string_view text) {
  for (const Remedy& known : kRemedies) {
    if (known.words != nullptr && text.find(known.words) != text.npos) return known.error;
  }
  return 0;
}

}  // namespace gw
