#include "host/video/png_sequence.h"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

#include "host/platform/remedy.h"
#include "host/platform/user_error.h"
#include "host/video/picture_file.h"

namespace gw {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw UserError(ExitCode::badFile, fmt::format("{} cannot take the frames: {}.", folder.string(), why));
}

bool isFrame(const fs::path& file) {
  return file.extension() == ".png" && file.filename().string().starts_with("frame_");
}

}  // namespace

PngSequence::PngSequence(const fs::path& folder) : folder_(folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) {
    if (!fs::create_directory(folder, error) && error) {
      refuse(folder, becauseNoFolder(error.value()));
    }
  } else if (!fs::is_directory(status)) {
    refuse(folder, "it is a file; give the name of a folder, or one that ends in .png or .mp4");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    refuse(folder, "it is write-protected; choose another folder or lift the protection");
  }
  fs::directory_iterator entries(folder, error);
  if (error) refuse(folder, because(error.value()));
  for (; entries != fs::directory_iterator(); entries.increment(error)) {
    if (error) refuse(folder, because(error.value()));
    if (isFrame(entries->path())) {
      refuse(folder, "there are frames of another render in it; give an empty folder or delete them");
    }
  }
}

void PngSequence::add(const Image& image) {
  // Thousands of them: the disk may take its time, a film of pictures is made again after a power cut.
  writePicture(folder_ / fmt::format("frame_{:06}.png", ++frames_), image, Sync::later);
}

}  // namespace gw
