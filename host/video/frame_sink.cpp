#include "host/video/frame_sink.h"

#include <optional>

#include "host/video/mp4_writer.h"
#include "host/video/picture_file.h"
#include "host/video/png_sequence.h"

namespace gw {

namespace {

class PictureFile final : public FrameSink {
 public:
  explicit PictureFile(const std::filesystem::path& path) : path_(path) { checkWritable(path); }

  void add(const Image& image) override { image_ = image; }
  void finish() override {
    if (image_) writePicture(path_, *image_);
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
  if (out.extension() == ".mp4") return std::make_unique<Mp4Writer>(out, size, framesPerSecond);
  return std::make_unique<PngSequence>(out);
}

}  // namespace gw
