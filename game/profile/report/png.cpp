#include "game/profile/report/png.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <memory>
#include <string_view>
#include <system_error>

#include "host/platform/external_tool.h"
#include "host/platform/part_file.h"
#include "host/platform/piped_process.h"
#include "host/platform/user_error.h"

namespace gw::profile {

namespace {

namespace fs = std::filesystem;

constexpr const char* kZoom = "2";  // of the picture's own pixels, for screens of twice the resolution

constexpr ExternalTool kRsvg = {"rsvg-convert", "librsvg2-bin", "open the SVG beside it"};

[[noreturn]] void fail(const std::string& sentence) {
  throw UserError(ExitCode::failedRun, sentence);
}

// None when it is not installed.
std::unique_ptr<PipedProcess> start(const fs::path& path, const std::string& part) {
  try {
    return std::make_unique<PipedProcess>(
        std::vector<std::string>{"rsvg-convert", "--format", "png", "--zoom", kZoom, "--output", part});
  } catch (const std::system_error& error) {
    if (error.code().value() == ENOENT) return nullptr;
    fail(fmt::format("rsvg-convert, which makes {}, does not start ({}): {}.", path.string(), error.code().message(),
                     kRsvg.otherwise));
  }
}

// From its signature to its last chunk, which holds nothing.
bool isWholePng(const std::string& bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("\x89PNG\r\n\x1a\n"sv) && bytes.ends_with("\0\0\0\0IEND\xae\x42\x60\x82"sv);
}

}  // namespace

bool writePngOf(const std::string& svg, const fs::path& path) {
  PartFile part(path);
  const auto converter = start(path, part.name());
  if (converter == nullptr) return false;
  const bool read = converter->write({reinterpret_cast<const uint8_t*>(svg.data()), svg.size()});
  const int code = converter->wait();
  if (code != 0 || !read) fail(couldNotMake(kRsvg, path, converter->output(), code));
  std::ifstream file(part.name(), std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  if (bytes.empty()) fail(madeNothing(kRsvg, path));
  if (!isWholePng(bytes)) fail(madeSomethingElse(kRsvg, path, "a picture"));
  part.become(Sync::later);
  return true;
}

}  // namespace gw::profile
