// Frames as an MP4 film, encoded by ffmpeg: H.264 where it can, else MPEG-4. The film grows in a temporary file
// beside its name and takes the name when it is whole: whatever ffmpeg does, an earlier film stays until then.
#pragma once

#include <memory>

#include "host/platform/part_file.h"
#include "host/platform/piped_process.h"
#include "host/video/frame_sink.h"

namespace gw {

class Mp4Writer final : public FrameSink {
 public:
  // Throws UserError when there is no ffmpeg, FileError when the file cannot be written.
  Mp4Writer(const std::filesystem::path& path, PixelSize size, uint32_t framesPerSecond);

  void add(const Image& image) override;
  void finish() override;

 private:
  // Waits for it. Throws UserError unless it ended well, having read all (`whole`), and has written a film.
  void endEncoder(bool whole);

  std::filesystem::path path_;
  PartFile part_;
  std::unique_ptr<PipedProcess> encoder_;  // ended before its file goes
  uint32_t frames_ = 0;
};

}  // namespace gw
