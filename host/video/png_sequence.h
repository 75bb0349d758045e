// Frames as pictures: frame_000001.png and so on, each of them whole.
#pragma once

#include "host/video/frame_sink.h"

namespace gw {

class PngSequence final : public FrameSink {
 public:
  // Makes the folder where there is none. Throws UserError when it cannot be one, or holds frames already: two
  // renders in one folder would look like one film.
  explicit PngSequence(const std::filesystem::path& folder);

  void add(const Image& image) override;
  void finish() override {}

 private:
  std::filesystem::path folder_;
  uint32_t frames_ = 0;
};

}  // namespace gw
