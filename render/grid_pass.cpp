#include "render/grid_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/gl_group.h"
#include "render/instanced_pass.h"

namespace gw {
namespace {

enum Uniform : GLint { kWorld = 1, kLines = 2, kMood = 3, kCuts = 4, kBends = 8 };  // locations in grid.vert

constexpr float kStep_m = 4;  // as in grid.vert
constexpr int kWalls = 4;
constexpr int kBands = 22;  // of the screen that tear as one: about 33 pixels each at 720
// Lines bend in pieces of about a metre.
constexpr int kBentPieces = 72, kBentPiecesOfABand = 4;
constexpr float kFlicker_hz = 14;  // slower looks like a fault, faster like noise
constexpr float kCalm = .01f;      // below this nothing tears: the screen is one band

struct Range {
  int first, count;
};

// The lines k * kStep_m strictly within the world and within the view.
Range linesInView(float centre, float half, float world_m) {
  const int first = int(std::max(std::ceil((centre - half) / kStep_m), 1.0f));
  const int last = int(std::min(std::floor((centre + half) / kStep_m), std::ceil(world_m / kStep_m) - 1));
  return {first, std::max(last - first + 1, 0)};
}

}  // namespace

GridPass::GridPass(const std::filesystem::path& assets)
    : program_(makeGlProgram(assets, "shaders/grid.vert", "shaders/grid.frag")), vertexArray_(makeGlVertexArray()) {}

void GridPass::draw(const GridFrame& frame) {
  const GlGroup group("grid");
  const Camera& camera = frame.camera;
  const float unrest = std::clamp(frame.unrest, 0.0f, 1.0f);
  const Range upright = linesInView(camera.centre_x, camera.halfWidth_m, frame.worldWidth_m);
  const Range level = linesInView(camera.centre_y, camera.halfHeight_m, frame.worldHeight_m);
  const int bands = unrest < kCalm ? 1 : kBands;
  const int bends = int(std::min(frame.bends.size(), size_t(kMaxGridBends)));
  const int pieces = bends == 0 ? 1 : bands == 1 ? kBentPieces : kBentPiecesOfABand;

  glClearColor(.010f * frame.brightness, .013f * frame.brightness, .032f * frame.brightness, 1);
  glClear(GL_COLOR_BUFFER_BIT);

  glUseProgram(program_.get());
  setCamera(camera);
  glUniform4f(kWorld, frame.worldWidth_m, frame.worldHeight_m, pixelsPerMetre(camera, frame.target), 0);
  glUniform3i(kCuts, pieces, bands, bends);
  std::array<float, 2 * 4 * kMaxGridBends> packed{};
  for (int i = 0; i < bends; ++i) {
    const GridBend& bend = frame.bends[size_t(i)];
    const float values[] = {bend.x, bend.y, bend.radius_m, bend.width_m, bend.strength_m, 0, 0, 0};
    std::copy(std::begin(values), std::end(values), packed.begin() + 8 * i);
  }
  if (bends > 0) glUniform4fv(kBends, 2 * bends, packed.data());
  glUniform4i(kLines, upright.first, upright.count, level.first, level.count);
  glUniform4f(kMood, frame.time_s, unrest, frame.brightness, std::floor(frame.time_s * kFlicker_hz));

  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBindVertexArray(vertexArray_.get());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * bands * (pieces + 1), upright.count + level.count + kWalls);
  checkGl("drawing the grid");
}

}  // namespace gw
