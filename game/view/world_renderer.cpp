#include "game/view/world_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "game/ui/hud.h"
#include "game/ui/overlay.h"
#include "game/ui/theme.h"
#include "game/view/gl_canvas.h"
#include "host/platform/user_error.h"
#ifdef GW_HAVE_CUDA
#include "render/cuda_interop.h"
#endif

namespace gw {

namespace {

constexpr uint32_t kSpareSprites = 64;  // the ship and what else is no entity
constexpr float kBlastShown_ticks = 24;
constexpr float kEdge_m = 3;  // sprites reach into view from outside, and move between ticks

// whyCopied: why frames of a CUDA device go through the host, when they do.
template <class Vertex>
std::unique_ptr<Stream<Vertex>> makeStream(uint32_t capacity, [[maybe_unused]] bool cuda,
                                           [[maybe_unused]] std::string& whyCopied) {
#ifdef GW_HAVE_CUDA
  if (cuda) {
    CudaStream<Vertex> made = makeCudaStream<Vertex>(capacity);
    whyCopied = std::move(made.why);
    return std::move(made.stream);
  }
#endif
  return std::make_unique<MappedStream<Vertex>>(capacity);
}

DrawView withEdge(const Camera& camera, Colouring colouring) {
  return {camera.centre_x, camera.centre_y, camera.halfWidth_m + kEdge_m, camera.halfHeight_m + kEdge_m, colouring};
}

EffectTime effectTimeOf(const Run& run, const WorldFrame& frame) {
  return {run.last().tick, frame.alpha + frame.afterEnd_ticks};
}

// Passes read shaders and fonts: an error there is one of a file.
RenderPasses loadPasses(const std::filesystem::path& assets) {
  try {
    return RenderPasses{assets};
  } catch (const std::runtime_error& error) {
    throw UserError(ExitCode::badFile, error.what());
  }
}

}  // namespace

WorldRenderer::WorldRenderer(const std::filesystem::path& assets) : passes_(loadPasses(assets)) {}

void WorldRenderer::makeStreams(const Simulation& simulation) {
  const bool cuda = simulation.onCuda();
  const uint32_t capacity = simulation.capacity() + kSpareSprites;
  std::string whyCopied;
  auto sprites = makeStream<SpriteVertex>(capacity, cuda, whyCopied);
  auto particles = makeStream<ParticleVertex>(cuda ? kParticlesDrawn : kParticlesDrawnWithoutGpu, cuda, whyCopied);
  stream_ = std::move(sprites);
  particleStream_ = std::move(particles);
  streamsOnCuda_ = cuda;
  streamCapacity_ = capacity;
  if (whyCopied.empty() || copiesReported_) return;
  copiesReported_ = true;
  std::fprintf(stderr, "Every frame is copied through the host, because %s: \"gpuwars devices\" lists what can draw.\n",
               whyCopied.c_str());
}

WorldRenderer::Filled WorldRenderer::fillStreams(Simulation& simulation, const DrawView& view,
                                                 const WorldFrame& frame) {
  const bool fits = stream_ && simulation.capacity() + kSpareSprites <= streamCapacity_;
  if (!fits || simulation.onCuda() != streamsOnCuda_) makeStreams(simulation);
  Filled filled;
  filled.sprites = stream_->begin();
  simulation.drawList(view, {filled.sprites.vertices, filled.sprites.capacity, filled.sprites.command});
  stream_->written();
  filled.particles = particleStream_->begin();
  if (frame.effects.particles) {
    simulation.particleList(view, frame.alpha + frame.afterEnd_ticks,
                            {filled.particles.vertices, filled.particles.capacity, filled.particles.command});
  }
  particleStream_->written();
  return filled;
}

WorldRenderer::Filled WorldRenderer::fill(Simulation& simulation, const DrawView& view, const WorldFrame& frame) {
  try {
    return fillStreams(simulation, view, frame);
  } catch (const DeviceError& error) {
    simulation.dropDevice(error.what());
    stream_.reset();  // its state is undefined
    return fillStreams(simulation, view, frame);
  }
}

void WorldRenderer::draw(Run& run, const Rules& rules, const FollowCamera& camera, const WorldFrame& frame,
                         const Screens& screens) {
  Simulation& simulation = run.simulation();
  const TickReport& report = run.last();
  Camera view = camera.view();  // a copy: the mouse aims by the one that does not shake
  const Shake::Offset shake = run.effects().shake().at(effectTimeOf(run, frame), frame.effects.shake);
  view.centre_x += shake.x;
  view.centre_y += shake.y;

  const auto [region, particles] = fill(simulation, withEdge(view, frame.colouring), frame);
  simulation.park();

  drawBackground(run, rules, view, frame);
  if (frame.effects.particles) passes_.particles.draw(particles, {view, frame.target, frame.brightness});
  particleStream_->end();
  drawEffects(run, view, frame);
  SpriteFrame sprites;
  sprites.camera = view;
  sprites.target = frame.target;
  sprites.alpha = frame.alpha;
  sprites.tick = float(report.tick) + frame.alpha;
  sprites.announced_ticks = float(rules.world.announced_ticks);
  sprites.brightness = frame.brightness;
  sprites.glow = frame.effects.glow;
  sprites.flashes = frame.effects.flash > 0;
  passes_.sprites.draw(region, sprites);
  drawRings(run, rules, view, frame);
  stream_->end();

  GlCanvas canvas(passes_.quads, passes_.text, frame.target);
  screens(canvas);
  canvas.nextLayer();
}

void WorldRenderer::drawBackground(Run& run, const Rules& rules, const Camera& camera, const WorldFrame& frame) {
  const TickReport& report = run.last();
  const float lost = 1 - budgetLeft(report.frameTime_us, rules.budget);
  std::vector<GridBend> bends;
  if (frame.effects.gridBending) bends = run.effects().gridBends().at(effectTimeOf(run, frame));
  GridFrame grid;
  grid.camera = camera;
  grid.worldWidth_m = run.simulation().worldWidth_m();
  grid.worldHeight_m = run.simulation().worldHeight_m();
  grid.target = frame.target;
  grid.time_s = (float(report.tick) + frame.alpha) * kTick_s;
  grid.unrest = lost * lost;
  grid.brightness = frame.brightness;
  grid.bends = bends;
  passes_.grid.draw(grid);
}

// What lies between the background and everything that lives, beside the particles.
void WorldRenderer::drawEffects(const Run& run, const Camera& camera, const WorldFrame& frame) {
  GlCanvas canvas(passes_.quads, passes_.text, frame.target);
  drawFlash(canvas, run.effects().flash().at(effectTimeOf(run, frame), frame.effects.flash));
  if (frame.effects.scorePops) {
    drawScorePops(canvas, run.effects().scorePops().at(effectTimeOf(run, frame)), camera, frame.brightness);
  }
  canvas.nextLayer();
}

void WorldRenderer::drawRings(const Run& run, const Rules& rules, const Camera& camera, const WorldFrame& frame) {
  const TickReport& report = run.last();
  if (report.flushRadius_m > 0) {
    const float share = std::clamp(report.flushRadius_m / std::max(rules.flush.reach_m, 1.0f), 0.0f, 1.0f);
    Ring ring;
    ring.x = report.flush_x;
    ring.y = report.flush_y;
    ring.radius_m = report.flushRadius_m + rules.flush.speed_mps * kTick_s * (frame.alpha - 1);
    ring.inside_m = 5;
    ring.outside_m = 0.6f;
    ring.colour = theme::faded(theme::kAccent, (1 - 0.6f * share) * frame.brightness);
    if (ring.radius_m > 0.1f) passes_.rings.draw(ring, camera, frame.target);
  }
  const RunMonitor::Contact& contact = run.monitor().lastContact();
  const float age = float(report.tick - contact.tick) + frame.alpha;
  if (contact.type != kTypeNone && age < kBlastShown_ticks) {
    const float share = age / kBlastShown_ticks;
    Ring ring;
    ring.x = report.shipPrevious_x + (report.ship_x - report.shipPrevious_x) * frame.alpha;
    ring.y = report.shipPrevious_y + (report.ship_y - report.shipPrevious_y) * frame.alpha;
    ring.radius_m = rules.ship.blast_m * std::sqrt(share) + 0.3f;
    ring.inside_m = 1.5f + 2 * (1 - share);
    ring.outside_m = 0.8f;
    ring.colour = theme::faded(theme::kDanger, (1 - share) * frame.brightness);
    passes_.rings.draw(ring, camera, frame.target);
  }
}

FollowCamera::Target cameraTarget(const TickReport& report, float alpha) {
  return {report.shipPrevious_x + (report.ship_x - report.shipPrevious_x) * alpha,
          report.shipPrevious_y + (report.ship_y - report.shipPrevious_y) * alpha, report.aim_rad,
          report.enemiesInView};
}

}  // namespace gw
