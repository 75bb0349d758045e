#include "host/video/mp4_writer.h"

#include <fmt/format.h>

#include <system_error>

#include "host/platform/external_tool.h"
#include "host/platform/user_error.h"
#include "host/video/mp4_check.h"

namespace gw {

namespace {

std::unique_ptr<PipedProcess> start(const std::vector<std::string>& arguments) {
  try {
    return std::make_unique<PipedProcess>(arguments);
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

// Said and meant: players take a film of this size for BT.709 whatever it is. Newer ffmpegs tag a film by what its
// pictures say of themselves, older ones by the options.
constexpr const char* kColours =
    "scale=out_color_matrix=bt709:out_range=tv,"
    "setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=bt709";

constexpr ExternalTool kFfmpeg = {"ffmpeg", "ffmpeg", "give a folder as --out to get the pictures"};

}  // namespace

Mp4Writer::Mp4Writer(const std::filesystem::path& path, PixelSize size, uint32_t framesPerSecond)
    : path_(path), part_(path) {
  std::vector<std::string> arguments = {"ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y"};
  const auto append = [&](const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
  };
  append({"-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", size.width, size.height),
          "-framerate", std::to_string(framesPerSecond), "-i", "pipe:0", "-an", "-c:v"});
  append(encoding());
  append({"-pix_fmt", "yuv420p", "-vf", kColours, "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc",
          "bt709", "-movflags", "+faststart", "-f", "mp4"});
  append({"file:" + part_.name()});  // a name with a colon is no protocol
  encoder_ = start(arguments);
}

void Mp4Writer::endEncoder(bool whole) {
  const auto refuse = [](const std::string& sentence) { throw UserError(ExitCode::failedRun, sentence); };
  const int code = encoder_->wait();
  if (code != 0 || !whole) refuse(couldNotMake(kFfmpeg, path_, encoder_->output(), code));
  std::error_code error;
  const auto bytes = std::filesystem::file_size(part_.name(), error);
  if (error || bytes == 0) refuse(madeNothing(kFfmpeg, path_));
  if (!isWholeMp4(part_.name())) refuse(madeSomethingElse(kFfmpeg, path_, "a film"));
}

void Mp4Writer::add(const Image& image) {
  if (!encoder_->write(image.rgb)) endEncoder(false);
  ++frames_;
}

void Mp4Writer::finish() {
  if (frames_ == 0) return;
  endEncoder(true);
  part_.become();
}

}  // namespace gw
