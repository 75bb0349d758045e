#include "render/particle_pass.h"

#include <cstddef>

#include "render/gl_group.h"

namespace gw {
namespace {

enum Uniform : GLint { kView = 1 };  // locations in particle.vert

const PassLayout kLayout{"particle",
                         "the particles",
                         {{VertexAttribute::Type::real, 4, offsetof(ParticleVertex, x)},
                          {VertexAttribute::Type::real, 2, offsetof(ParticleVertex, size_m)},
                          {VertexAttribute::Type::integer, 1, offsetof(ParticleVertex, colour)}}};

}  // namespace

ParticlePass::ParticlePass(const std::filesystem::path& assets) : pass_(assets, kLayout) {}

void ParticlePass::draw(const ParticleRegion& region, const ParticleFrame& frame) {
  const GlGroup group("particles");
  glUseProgram(pass_.program());
  setCamera(frame.camera);
  glUniform2f(kView, pixelsPerMetre(frame.camera, frame.target), frame.brightness);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  pass_.draw(GL_TRIANGLES, region);
}

}  // namespace gw
