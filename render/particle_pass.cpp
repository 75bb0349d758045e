#include "render/particle_pass.h"

#include <cstddef>

#include "render/gl_group.h"

namespace gw {
namespace {

enum Uniform : GLint { kCamera = 0, kView = 1 };  // locations in particle.vert
enum Attribute : GLuint { kPlaces = 0, kSizeLight = 1, kLook = 2 };
constexpr GLuint kInstances = 0;  // the one binding all attributes come from

}  // namespace

ParticlePass::ParticlePass(const std::filesystem::path& assets)
    : program_(makeGlProgram(assets, "shaders/particle.vert", "shaders/particle.frag")),
      vertexArray_(makeGlVertexArray()) {
  const GLuint array = vertexArray_.get();
  glVertexArrayAttribFormat(array, kPlaces, 4, GL_FLOAT, GL_FALSE, offsetof(ParticleVertex, x));
  glVertexArrayAttribFormat(array, kSizeLight, 2, GL_FLOAT, GL_FALSE, offsetof(ParticleVertex, size_m));
  glVertexArrayAttribIFormat(array, kLook, 1, GL_UNSIGNED_INT, offsetof(ParticleVertex, colour));
  for (GLuint attribute : {kPlaces, kSizeLight, kLook}) {
    glEnableVertexArrayAttrib(array, attribute);
    glVertexArrayAttribBinding(array, attribute, kInstances);
  }
  glVertexArrayBindingDivisor(array, kInstances, 1);
  checkGl("preparing the particles");
}

void ParticlePass::draw(const ParticleRegion& region, const ParticleFrame& frame) {
  const GlGroup group("particles");
  const Camera& camera = frame.camera;
  glUseProgram(program_.get());
  glUniform4f(kCamera, camera.centre_x, camera.centre_y, 1 / camera.halfWidth_m, 1 / camera.halfHeight_m);
  glUniform2f(kView, float(frame.target.height) / (2 * camera.halfHeight_m), frame.brightness);

  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBindVertexArray(vertexArray_.get());
  glVertexArrayVertexBuffer(vertexArray_.get(), kInstances, region.vertexBuffer, GLintptr(region.vertexOffset_bytes),
                            sizeof(ParticleVertex));
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, region.commandBuffer);
  glDrawArraysIndirect(GL_TRIANGLES, reinterpret_cast<const void*>(region.commandOffset_bytes));
  checkGl("drawing the particles");
}

}  // namespace gw
