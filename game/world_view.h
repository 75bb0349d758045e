// Draws a run: background and effects, everything that lives on top of them, rings, and then whatever screens put
// on the canvas.
// Works in a window and headless alike; reads the run, never changes it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "game/camera.h"
#include "game/run.h"
#include "game/settings/settings.h"
#include "game/ui/canvas.h"
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
};

class WorldView {
 public:
  // How many particles are drawn at most: all there are where there is a GPU; without one as many as cost 7 ms of
  // processor time (docs/effects.md). A busy fight has 500 in view.
  static constexpr uint32_t kParticlesDrawn = 16384, kParticlesDrawnWithoutGpu = 3072;

  // Needs a current GL context. `capacity` is the simulation's; `cuda`: kernels write on a CUDA device.
  // Throws UserError with ExitCode::badFile when an asset is missing or damaged, and DeviceError when CUDA fails.
  WorldView(const std::filesystem::path& assets, uint32_t capacity, bool cuda);

  // The run goes on on another device. What threw before, between frames or within one, leaves no trace. Throws
  // DeviceError when CUDA fails here too; the streams are then as before.
  void remakeStreams(bool cuda);

  // Throws DeviceError when CUDA fails: remakeStreams(false) then goes on without it.
  using Screens = std::function<void(Canvas&)>;
  void draw(Run& run, const Rules& rules, const FollowCamera& camera, const WorldFrame& frame, const Screens& screens);

 private:
  void drawBackground(Run& run, const Rules& rules, const Camera& camera, const WorldFrame& frame);
  void drawEffects(const Run& run, const Camera& camera, const WorldFrame& frame);
  void drawRings(const Run& run, const Rules& rules, const Camera& camera, const WorldFrame& frame);

  uint32_t capacity_;
  bool toldOfCopies_ = false;
  std::unique_ptr<SpriteStream> stream_;
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
