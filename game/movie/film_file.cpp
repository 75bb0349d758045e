#include "game/movie/film_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>
#include <utility>

#include "game/files/atomic_file.h"
#include "game/user_error.h"

namespace gw {

namespace {

std::unique_ptr<FedProcess> start(const std::vector<std::string>& arguments) {
  try {
    return std::make_unique<FedProcess>(arguments);
  } catch (const std::system_error& error) {
    if (error.code().value() == ENOENT) {
      throw UserError(ExitCode::failedRun,
                      "There is no ffmpeg, which encodes films: install it (Debian, Ubuntu: apt install ffmpeg), or "
                      "give a folder as --out to get the pictures.");
    }
    throw UserError(ExitCode::failedRun,
                    fmt::format("ffmpeg, which encodes films, does not start ({}): give a folder as --out to get the "
                                "pictures.",
                                error.code().message()));
  }
}

std::vector<std::string> encoding() {
  const auto ffmpeg = start({"ffmpeg", "-hide_banner", "-nostdin", "-encoders"});
  if (ffmpeg->wait() == 0 && ffmpeg->output().find(" libx264 ") != std::string::npos) {
    return {"libx264", "-preset", "medium", "-crf", "18"};
  }
  return {"mpeg4", "-q:v", "3"};
}

std::string lastLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.substr(text.find_last_of('\n') + 1);
}

}  // namespace

FilmFile::FilmFile(const std::filesystem::path& path, PixelSize size, uint32_t framesPerSecond)
    : path_(path), target_(writingDestination(path)) {
  checkWritable(path);
  std::vector<std::string> arguments = {"ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y"};
  const auto append = [&](const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
  };
  append({"-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", size.width, size.height),
          "-framerate", std::to_string(framesPerSecond), "-i", "pipe:0", "-an", "-c:v"});
  append(encoding());
  part_ = openPart(path_, target_);
  // Said and meant: players take a film of this size for BT.709 whatever it is.
  append({"-pix_fmt", "yuv420p", "-vf", "scale=out_color_matrix=bt709:out_range=tv", "-colorspace", "bt709",
          "-color_primaries", "bt709", "-color_trc", "bt709", "-movflags", "+faststart", "-f", "mp4"});
  append({"file:" + part_.name});  // a name with a colon is no protocol
  try {
    encoder_ = start(arguments);
  } catch (const UserError&) {
    dropPart();
    throw;
  }
}

FilmFile::~FilmFile() {
  encoder_.reset();
  dropPart();
}

void FilmFile::dropPart() {
  if (part_.name.empty()) return;
  unlink(part_.name.c_str());
  part_.name.clear();
  if (part_.descriptor >= 0) close(std::exchange(part_.descriptor, -1));
}

void FilmFile::fail(const std::string& why) {
  throw UserError(ExitCode::failedRun,
                  fmt::format("ffmpeg could not make {} ({}): make room on the disk, or give a folder as --out to get "
                              "the pictures.",
                              path_.string(), why));
}

void FilmFile::endEncoder() {
  const int code = encoder_->wait();
  if (code == 0) return;
  const std::string words = lastLine(encoder_->output());
  fail(words.empty() ? fmt::format("it ended with {}", code) : words);
}

void FilmFile::add(const Image& image) {
  if (!encoder_->write(image.rgb)) {
    endEncoder();
    fail("it stopped reading");
  }
  ++frames_;
}

void FilmFile::finish() {
  if (frames_ == 0) return;
  endEncoder();
  becomeTarget(part_, path_, target_);
  part_.name.clear();
}

}  // namespace gw
