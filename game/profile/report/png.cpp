#include "game/profile/report/png.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>

#include "game/files/atomic_file.h"
#include "game/files/part_file.h"
#include "game/processes/fed_process.h"
#include "game/user_error.h"

namespace gw::profile {

namespace {

namespace fs = std::filesystem;

constexpr const char* kZoom = "2";  // of the picture's own pixels, for screens of twice the resolution

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw UserError(ExitCode::failedRun,
                  fmt::format("rsvg-convert could not make {} ({}): make room on the disk, or open the SVG beside it.",
                              path.string(), why));
}

// None when it is not installed.
std::unique_ptr<FedProcess> start(const fs::path& path, const std::string& part) {
  try {
    return std::make_unique<FedProcess>(
        std::vector<std::string>{"rsvg-convert", "--format", "png", "--zoom", kZoom, "--output", part});
  } catch (const std::system_error& error) {
    if (error.code().value() == ENOENT) return nullptr;
    fail(path, error.code().message());
  }
}

std::string lastLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.substr(text.find_last_of('\n') + 1);
}

// Gone unless it was renamed.
struct Part {
  std::string name;
  ~Part() { unlink(name.c_str()); }
};

}  // namespace

bool writePngOf(const std::string& svg, const fs::path& path) {
  const fs::path target = writingDestination(path);
  const Part part{fmt::format("{}.part-{}", target.string(), getpid())};
  const auto converter = start(path, part.name);
  if (converter == nullptr) return false;
  const bool read = converter->write({reinterpret_cast<const uint8_t*>(svg.data()), svg.size()});
  const int code = converter->wait();
  if (code != 0 || !read) {
    const std::string words = lastLine(converter->output());
    fail(path, words.empty() ? fmt::format("it ended with {}", code) : words);
  }
  std::error_code error;
  fs::rename(part.name, target, error);
  if (error) fail(path, error.message());
  return true;
}

}  // namespace gw::profile
