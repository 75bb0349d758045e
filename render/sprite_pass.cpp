#include "render/sprite_pass.h"

#include <algorithm>

#include "render/gl_group.h"
#include "render/sprite_shape_defines.h"

namespace gw {
namespace {

enum Uniform : GLint { kView = 1, kLight = 2, kAnnounced = 3 };  // locations in sprite.vert

const PassLayout kLayout{"sprite",
                         "the sprites",
                         {{VertexAttribute::Type::real, 4, offsetof(SpriteVertex, x)},
                          {VertexAttribute::Type::real, 2, offsetof(SpriteVertex, angle_rad)},
                          {VertexAttribute::Type::integer, 2, offsetof(SpriteVertex, shapeFlags)}},
                         spriteShapeDefines()};

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

SpritePass::SpritePass(const std::filesystem::path& assets) : pass_(assets, kLayout) {}

void SpritePass::draw(const StreamRegion& region, const SpriteFrame& frame) {
  const GlGroup group("sprites");
  const Glow glow = glowOf(frame.glow);
  glUseProgram(pass_.program());
  setCamera(frame.camera);
  glUniform4f(kView, frame.alpha, frame.tick, pixelsPerMetre(frame.camera, frame.target), frame.brightness);
  glUniform4f(kLight, glow.share, glow.most_px, glow.strength, frame.flashes ? 1.0f : 0.0f);
  glUniform1f(kAnnounced, frame.announced_ticks);

  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // premultiplied: covers where alpha is, adds light where it is not
  pass_.draw(GL_TRIANGLE_STRIP, region);
}

}  // namespace gw
