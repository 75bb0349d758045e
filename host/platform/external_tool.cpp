#include "host/platform/external_tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <sstream>

#include "host/platform/remedy.h"

namespace gw {
namespace {

// "[out#0/mp4 @ 0x55d0c8] Error" -> "Error"
std::string withoutOrigin(std::string line) {
  std::replace_if(
      line.begin(), line.end(), [](char c) { return uint8_t(c) < 0x20 || c == 0x7f; }, ' ');
  while (line.starts_with('[') && line.find("] ") != line.npos) line.erase(0, line.find("] ") + 2);
  const size_t first = line.find_first_not_of(' '), last = line.find_last_not_of(' ');
  return first == line.npos ? "" : line.substr(first, last - first + 1);
}

std::string plainPackage(const ExternalTool& maker) {
  return fmt::format(
      "a snap or Flatpak sees other folders; install it as a plain package (Debian, Ubuntu: apt install {})",
      maker.package);
}

// What helps against `error`, and a comma; nothing when that is not known. This program has made the file just before,
// so a folder that the other one does not find, or may not write to, is one that is kept from it.
std::string programRemedy(const ExternalTool& maker, int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
    case EACCES:
    case EPERM:
    case EROFS:
      return plainPackage(maker) + ", or ";
    case 0:
      return "";
    default:
      return fmt::format("{}, or ", remedyFor(error));
  }
}

}  // namespace

std::string firstCause(const std::string& said) {
  std::istringstream lines(said);
  std::string first;
  for (std::string line; std::getline(lines, line);) {
    line = withoutOrigin(line);
    if (errorNamedIn(line) != 0) return line;
    if (first.empty()) first = line;
  }
  return first;
}

std::string couldNotMake(const ExternalTool& maker, const std::filesystem::path& path, const std::string& said,
                         int code) {
  std::string cause = firstCause(said);
  const int error = errorNamedIn(cause);
  if (cause.empty()) cause = code == 0 ? "it stopped reading" : fmt::format("it ended with {}", code);
  return fmt::format("{} could not make {} ({}): {}{}.", maker.program, path.string(), cause,
                     programRemedy(maker, error), maker.otherwise);
}

std::string madeNothing(const ExternalTool& maker, const std::filesystem::path& path) {
  return fmt::format("{} ended well but wrote nothing to {}: {}, or {}.", maker.program, path.string(),
                     plainPackage(maker), maker.otherwise);
}

std::string madeSomethingElse(const ExternalTool& maker, const std::filesystem::path& path, const char* what) {
  return fmt::format(
      "{} ended well but what it wrote to {} is not {}, whole: reinstall it (Debian, Ubuntu: apt "
      "install --reinstall {}), or {}.",
      maker.program, path.string(), what, maker.package, maker.otherwise);
}

}  // namespace gw
