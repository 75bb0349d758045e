#include "render/sprite_pass.h"

#include <algorithm>

#include "render/gl_group.h"
#include "render/sprite_shape_defines.h"

namespace gw {
namespace {

enum Uniform : GLint { kCamera = 0, kView = 1, kLight = 2, kAnnounced = 3 };  // locations in sprite.vert
enum Attribute : GLuint { kPlaces = 0, kAngleSize = 1, kLook = 2 };
constexpr GLuint kInstances = 0;  // the one binding all attributes come from

struct Glow {
  float share, most_px, strength;
};

// The cost of a sprite is its pixels: reach is what to lower when a frame takes too long.
Glow glowOf(float amount) {
  constexpr Glow kLow{.4f, 5, .40f}, kHigh{.9f, 14, .50f};
  const auto between = [](float from, float to, float share) { return from * (1 - share) + to * share; };
  amount = std::clamp(amount, kGlowOff, kGlowHigh);
  if (amount <= kGlowLow) {
    const float share = amount / kGlowLow;
    return {kLow.share * share, kLow.most_px * share, kLow.strength * share};
  }
  const float share = (amount - kGlowLow) / (kGlowHigh - kGlowLow);
  return {between(kLow.share, kHigh.share, share), between(kLow.most_px, kHigh.most_px, share),
          between(kLow.strength, kHigh.strength, share)};
}

}  // namespace

SpritePass::SpritePass(const std::filesystem::path& assets)
    : program_(makeGlProgram(assets, "shaders/sprite.vert", "shaders/sprite.frag", spriteShapeDefines())),
      vertexArray_(makeGlVertexArray()) {
  const GLuint array = vertexArray_.get();
  glVertexArrayAttribFormat(array, kPlaces, 4, GL_FLOAT, GL_FALSE, offsetof(SpriteVertex, x));
  glVertexArrayAttribFormat(array, kAngleSize, 2, GL_FLOAT, GL_FALSE, offsetof(SpriteVertex, angle_rad));
  glVertexArrayAttribIFormat(array, kLook, 2, GL_UNSIGNED_INT, offsetof(SpriteVertex, shapeFlags));
  for (GLuint attribute : {kPlaces, kAngleSize, kLook}) {
    glEnableVertexArrayAttrib(array, attribute);
    glVertexArrayAttribBinding(array, attribute, kInstances);
  }
  glVertexArrayBindingDivisor(array, kInstances, 1);
  checkGl("preparing the sprites");
}

void SpritePass::draw(const StreamRegion& region, const SpriteFrame& frame) {
  const GlGroup group("sprites");
  const Camera& camera = frame.camera;
  const Glow glow = glowOf(frame.glow);
  const float pixelsPerMetre = float(frame.target.height) / (2 * camera.halfHeight_m);

  glUseProgram(program_.get());
  glUniform4f(kCamera, camera.centre_x, camera.centre_y, 1 / camera.halfWidth_m, 1 / camera.halfHeight_m);
  glUniform4f(kView, frame.alpha, frame.tick, pixelsPerMetre, frame.brightness);
  glUniform4f(kLight, glow.share, glow.most_px, glow.strength, frame.flashes ? 1.0f : 0.0f);
  glUniform1f(kAnnounced, frame.announced_ticks);

  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // premultiplied: covers where alpha is, adds light where it is not
  glBindVertexArray(vertexArray_.get());
  // The region moves by its binding's offset, so that baseInstance stays 0 in what the kernel writes.
  glVertexArrayVertexBuffer(vertexArray_.get(), kInstances, region.vertexBuffer, GLintptr(region.vertexOffset_bytes),
                            sizeof(SpriteVertex));
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, region.commandBuffer);
  glDrawArraysIndirect(GL_TRIANGLE_STRIP, reinterpret_cast<const void*>(region.commandOffset_bytes));
  checkGl("drawing the sprites");
}

}  // namespace gw
