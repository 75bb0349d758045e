// Draws a run: background and effects, then all entities, rings, and finally what the screens put on the canvas.
// Works in a window and headless alike; reads the run, never changes it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "game/session/run.h"
#include "game/settings/settings.h"
#include "game/ui/canvas.h"
#include "game/view/follow_camera.h"
#include "render/grid_pass.h"
#include "render/particle_pass.h"
#include "render/quad_pass.h"
#include "render/ring_pass.h"
#include "render/sprite_pass.h"
#include "render/text_pass.h"
#include "render/vertex_stream.h"

namespace gw {

struct WorldFrame {
  PixelSize target;
  float alpha = 1;           // between the last two ticks
  float brightness = 1;      // of the world; less behind menus
  float afterEnd_ticks = 0;  // once the run is over nothing moves but its effects: for this long so far
  Settings::Effects effects{};
  Colouring colouring = Colouring::types;
};

// Every render pass of the game. Needs a current GL context.
struct RenderPasses {
  std::filesystem::path assets;
  GridPass grid{assets};
  ParticlePass particles{assets};
  SpritePass sprites{assets};
  RingPass rings{assets};
  QuadPass quads{assets};
  TextPass text{assets};
};

class WorldRenderer {
 public:
  // How many particles are drawn at most: all there are where there is a GPU; without one as many as cost 7 ms of
  // processor time (docs/design/effects.md). A busy fight has 500 in view.
  static constexpr uint32_t kParticlesDrawn = 16384, kParticlesDrawnWithoutGpu = 3072;

  // Needs a current GL context.
  // Throws UserError with ExitCode::badFile when an asset is missing or damaged.
  explicit WorldRenderer(const std::filesystem::path& assets);

  // On whichever device the run is now. When CUDA fails on the way to OpenGL the simulation drops that device
  // (Simulation::dropDevice), and the picture is drawn from the next one; DeviceError when there is none.
  using Screens = std::function<void(Canvas&)>;
  void draw(Run& run, const Rules& rules, const FollowCamera& camera, const WorldFrame& frame, const Screens& screens);

 private:
  struct Filled {
    StreamRegion sprites;
    ParticleRegion particles;
  };
  Filled fill(Simulation& simulation, const DrawView& view, const WorldFrame& frame);
  Filled fillStreams(Simulation& simulation, const DrawView& view, const WorldFrame& frame);
  void makeStreams(const Simulation& simulation);
  void drawBackground(Run& run, const Rules& rules, const Camera& camera, const WorldFrame& frame);
  void drawEffects(const Run& run, const Camera& camera, const WorldFrame& frame);
  void drawRings(const Run& run, const Rules& rules, const Camera& camera, const WorldFrame& frame);

  bool copiesReported_ = false;
  bool streamsOnCuda_ = false;            // what the streams are for
  uint32_t streamCapacity_ = 0;           // sprites
  std::unique_ptr<SpriteStream> stream_;  // null: not made yet
  std::unique_ptr<ParticleStream> particleStream_;
  RenderPasses passes_;
};

// The camera's target at this moment between two ticks.
FollowCamera::Target cameraTarget(const TickReport& report, float alpha);

}  // namespace gw
