// Draws particles: short streaks of light, added to what is there. They lie under everything that lives.
#pragma once

#include <filesystem>

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/vertex_stream.h"

namespace gw {

struct ParticleFrame {
  Camera camera;
  PixelSize target;
  float brightness = 1;  // less behind menus
};

class ParticlePass {
 public:
  explicit ParticlePass(const std::filesystem::path& assets);

  // Call between written() and end() of the region's stream.
  void draw(const ParticleRegion& region, const ParticleFrame& frame);

 private:
  GlProgram program_;
  GlVertexArray vertexArray_;
};

}  // namespace gw
