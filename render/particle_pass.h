// Draws particles: short streaks of light, blended additively, below all entities.
#pragma once

#include <filesystem>

#include "render/instanced_pass.h"

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
  InstancedPass<ParticleVertex> pass_;
};

}  // namespace gw
