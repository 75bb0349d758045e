// RenderDoc and Nsight show passes by these names; here the driver's debug messages do.
#include <algorithm>
#include <string>
#include <vector>

#include "render/gl_group.h"
#include "render/grid_pass.h"
#include "render/particle_pass.h"
#include "render/quad_pass.h"
#include "render/ring_pass.h"
#include "render/sprite_pass.h"
#include "render/text_pass.h"
#include "render/vertex_stream.h"
#include "tests/render/gl_fixture.h"

namespace gw {
namespace {

constexpr Camera kCamera{0, 0, 16, 9};

class DebugGroups : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    glDebugMessageCallback(remember, this);
  }

  // "+name" for every group that begins, "-name" for one that ends.
  static void GLAPIENTRY remember(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* test) {
    auto& seen = const_cast<DebugGroups*>(static_cast<const DebugGroups*>(test))->seen_;
    if (type == GL_DEBUG_TYPE_PUSH_GROUP) seen.push_back(std::string("+") + text);
    if (type == GL_DEBUG_TYPE_POP_GROUP) seen.push_back(std::string("-") + text);
  }

  using Names = std::vector<std::string>;
  Names seen_;
};

TEST_F(DebugGroups, NestAndEndWithTheirOwner) {
  {
    const GlGroup outer("outer");
    const GlGroup inner("inner");
  }
  EXPECT_EQ(seen_, (Names{"+outer", "+inner", "-inner", "-outer"}));
}

TEST_F(DebugGroups, EveryPassIsSeenByItsName) {
  GridPass(kAssets).draw({.camera = kCamera, .target = kSize, .worldWidth_m = 100, .worldHeight_m = 100});

  ParticlePass particles(kAssets);
  MappedStream<ParticleVertex> particleStream(4);
  const ParticleRegion particleRegion = particleStream.begin();
  particles.draw(particleRegion, {kCamera, kSize, 1});
  particleStream.end();

  SpritePass sprites(kAssets);
  VertexStream spriteStream(4);
  const StreamRegion spriteRegion = spriteStream.begin();
  sprites.draw(spriteRegion, {.camera = kCamera, .target = kSize});
  spriteStream.end();

  Ring ring;
  ring.colour = {1, 1, 1, 1};
  RingPass(kAssets).draw(ring, kCamera, kSize);

  QuadPass quads(kAssets);
  quads.rectangle(0, 0, 10, 10, {1, 1, 1, 1});
  quads.flush(kSize);

  TextPass text(kAssets);
  text.add("7", 20, 20, {});
  text.flush(kSize);

  Names wanted;
  for (const char* name : {"grid", "particles", "sprites", "ring", "user interface", "text"}) {
    wanted.push_back(std::string("+") + name);
    wanted.push_back(std::string("-") + name);
  }
  EXPECT_EQ(seen_, wanted);
}

TEST_F(DebugGroups, APassWithNothingToDrawLeavesNoEmptyGroup) {
  QuadPass(kAssets).flush(kSize);
  TextPass(kAssets).flush(kSize);
  Ring ring;
  ring.radius_m = 0;
  RingPass(kAssets).draw(ring, kCamera, kSize);
  EXPECT_EQ(seen_, Names{});
}

}  // namespace
}  // namespace gw
