#include "game/movie/frame_sink.h"

#include <fmt/format.h>

#include <optional>

#include "game/files/atomic_file.h"
#include "game/movie/film_file.h"
#include "game/movie/picture_folder.h"
#include "game/user_error.h"

namespace gw {

namespace {

class PictureFile final : public FrameSink {
 public:
  explicit PictureFile(const std::filesystem::path& path) : path_(path) { checkWritable(path); }

  void add(const Image& image) override { image_ = image; }
  void finish() override {
    if (!image_) return;
    try {
      writePng(path_, *image_);
    } catch (const std::runtime_error& error) {
      throw UserError(ExitCode::badFile, error.what());
    }
  }

 private:
  std::filesystem::path path_;
  std::optional<Image> image_;
};

}  // namespace

bool isOnePicture(const std::filesystem::path& out) {
  return out.extension() == ".png";
}

std::unique_ptr<FrameSink> openFrameSink(const std::filesystem::path& out, PixelSize size, uint32_t framesPerSecond) {
  if (isOnePicture(out)) return std::make_unique<PictureFile>(out);
  if (out.extension() == ".mp4") return std::make_unique<FilmFile>(out, size, framesPerSecond);
  return std::make_unique<PictureFolder>(out);
}

}  // namespace gw
