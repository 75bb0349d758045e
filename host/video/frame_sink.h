// Where the frames of a replay go: a folder of pictures, one picture, or a film.
#pragma once

#include <filesystem>
#include <memory>

#include "render/screenshot.h"

namespace gw {

class FrameSink {
 public:
  virtual ~FrameSink() = default;  // without finish() nothing half-made is left
  // Throws UserError or FileError, one sentence.
  virtual void add(const Image& image) = 0;
  // What was added is whole from here.
  virtual void finish() = 0;
};

// By the name: .mp4 is a film, .png one picture (the last that is added), anything else a folder. Whatever can be
// known to go wrong is reported here, before anything is drawn: throws UserError or FileError.
std::unique_ptr<FrameSink> openFrameSink(const std::filesystem::path& out, PixelSize size, uint32_t framesPerSecond);

bool isOnePicture(const std::filesystem::path& out);

}  // namespace gw
