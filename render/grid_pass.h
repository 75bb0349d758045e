// The background: dark space, the world's grid lines every 4 m with data running along every fifth, and
// the glowing walls. Lines only, no full-screen quad: on llvmpipe every pixel is paid for.
#pragma once

#include <filesystem>
#include <span>

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/grid_bend.h"

namespace gw {

struct GridFrame {
  Camera camera;
  PixelSize target;
  float worldWidth_m = 192, worldHeight_m = 108;  // the world spans 0..width, 0..height
  float time_s = 0;                               // game time: what moves stops with the game
  float unrest = 0;                               // 0 calm .. 1 the frame budget is spent: lines flicker and tear
  float brightness = 1;
  std::span<const GridBend> bends{};  // at most kMaxGridBends; walls do not bend: they are what is collided with
};

class GridPass {
 public:
  explicit GridPass(const std::filesystem::path& assets);

  // Clears the bound target and draws the background: the first pass of a frame.
  void draw(const GridFrame& frame);

 private:
  GlProgram program_;
  GlVertexArray vertexArray_;
};

}  // namespace gw
