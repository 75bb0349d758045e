// Draws a run: background and effects, everything that lives on top of them, rings, and then whatever screens put
// on the canvas.
// Works in a window and headless alike; reads the run, never changes it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "game/session/run.h"
#include "game/settings/settings.h"
#include "game/ui/canvas.h"
#include "game/view/camera.h"
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

class WorldView {
 public:
  // How many particles are drawn at most: all there are where there is a GPU; without one as many as cost 7 ms of
  // processor time (docs/design/effects.md). A busy fight has 500 in view.
  static constexpr uint32_t kParticlesDrawn = 16384, kParticlesDrawnWithoutGpu = 3072;

  // Needs a current GL context. `capacity` is the simulation's.
  // Throws UserError with ExitCode::badFile when an asset is missing or damaged.
  WorldView(const std::filesystem::path& assets, uint32_t capacity);

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
  void makeStreams(bool cuda);
  void drawBackground(Run& run, const Rules& rules, const Camera& camera, const WorldFrame& frame);
  void drawEffects(const Run& run, const Camera& camera, const WorldFrame& frame);
  void drawRings(const Run& run, const Rules& rules, const Camera& camera, const WorldFrame& frame);

  uint32_t capacity_;
  bool toldOfCopies_ = false;
  bool streamsOnCuda_ = false;            // what the streams are for
  std::unique_ptr<SpriteStream> stream_;  // null: not made yet
  std::unique_ptr<ParticleStream> particleStream_;
  GridPass grid_;
  ParticlePass particles_;
  SpritePass sprites_;
  RingPass rings_;
  QuadPass quads_;
  TextPass text_;
};

// The camera's target at this moment between two ticks.
FollowCamera::Target cameraTarget(const TickReport& report, float alpha);

}  // namespace gw
