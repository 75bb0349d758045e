#include "render/ring_pass.h"

#include <algorithm>

#include "render/gl_group.h"
#include "render/instanced_pass.h"

namespace gw {
namespace {

enum Uniform : GLint { kRing = 1, kReach = 2, kTint = 3 };  // locations in ring.vert and ring.frag

constexpr int kSteps = 96;  // a circle as high as the screen then bends less than a pixel per step

}  // namespace

RingPass::RingPass(const std::filesystem::path& assets)
    : program_(makeGlProgram(assets, "shaders/ring.vert", "shaders/ring.frag")), vertexArray_(makeGlVertexArray()) {}

void RingPass::draw(const Ring& ring, const Camera& camera, PixelSize target) {
  if (ring.radius_m <= 0 || ring.colour.alpha <= 0) return;
  const GlGroup group("ring");
  constexpr float kLeast_m = 1e-3f;  // the shader divides by the reach
  glUseProgram(program_.get());
  setCamera(camera);
  glUniform4f(kRing, ring.x, ring.y, ring.radius_m, float(kSteps));
  glUniform4f(kReach, std::max(ring.inside_m, kLeast_m), std::max(ring.outside_m, kLeast_m),
              pixelsPerMetre(camera, target), 0);
  glUniform4f(kTint, ring.colour.red, ring.colour.green, ring.colour.blue, ring.colour.alpha);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBindVertexArray(vertexArray_.get());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (kSteps + 1));
  checkGl("drawing a ring");
}

}  // namespace gw
