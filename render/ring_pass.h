// A glowing circle: the flush ring, and with a wide soft edge the blast round the ship. Drawn as a band of
// triangles, so that a ring over the whole screen costs only its own pixels.
#pragma once

#include <filesystem>

#include "render/camera.h"
#include "render/gl_objects.h"

namespace gw {

struct Ring {
  float x = 0, y = 0, radius_m = 1;
  float inside_m = 1.5f, outside_m = 0.5f;  // how far its light fades to either side
  Rgba colour;                              // alpha: how bright
};

class RingPass {
 public:
  explicit RingPass(const std::filesystem::path& assets);
  void draw(const Ring& ring, const Camera& camera, PixelSize target);

 private:
  GlProgram program_;
  GlVertexArray vertexArray_;
};

}  // namespace gw
