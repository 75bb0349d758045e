#include "game/world_view.h"

#include <algorithm>
#include <cmath>

#include "game/gl_canvas.h"
#include "game/ui/hud.h"
#include "game/ui/theme.h"
#include "game/user_error.h"
#ifdef GW_HAVE_CUDA
#include "render/cuda_interop.h"
#endif

namespace gw {

namespace {

constexpr uint32_t kSpareSprites = 64;  // the ship and what else is no entity
constexpr float kBlastShown_ticks = 24;

std::unique_ptr<SpriteStream> makeStream(uint32_t capacity, [[maybe_unused]] bool cuda) {
#ifdef GW_HAVE_CUDA
  if (cuda) return makeCudaSpriteStream(capacity).stream;
#endif
  return std::make_unique<VertexStream>(capacity);
}

// Passes read shaders and fonts: what goes wrong there is a bad file.
template <class Pass>
Pass loaded(const std::filesystem::path& assets) {
  try {
    return Pass(assets);
  } catch (const std::runtime_error& error) {
    throw UserError(ExitCode::badFile, error.what());
  }
}

}  // namespace

WorldView::WorldView(const std::filesystem::path& assets, uint32_t capacity, bool cuda)
    : capacity_(capacity + kSpareSprites),
      stream_(makeStream(capacity_, cuda)),
      grid_(loaded<GridPass>(assets)),
      sprites_(loaded<SpritePass>(assets)),
      rings_(loaded<RingPass>(assets)),
      quads_(loaded<QuadPass>(assets)),
      text_(loaded<TextPass>(assets)) {}

void WorldView::draw(Run& run, const Rules& rules, const FollowCamera& camera, const WorldFrame& frame,
                     const Screens& screens) {
  Simulation& simulation = run.simulation();
  const TickReport& report = run.last();
  const Camera view = camera.view();
  constexpr float kEdge_m = 3;  // sprites reach into view from outside, and move between ticks

  const StreamRegion region = stream_->begin();
  simulation.drawList({view.centre_x, view.centre_y, view.halfWidth_m + kEdge_m, view.halfHeight_m + kEdge_m},
                      {region.vertices, region.capacity, region.command});
  stream_->written();
  simulation.park();

  const float lost = 1 - budgetLeft(report.frameTime_us, rules.budget);
  GridFrame grid;
  grid.camera = view;
  grid.worldWidth_m = simulation.worldWidth_m();
  grid.worldHeight_m = simulation.worldHeight_m();
  grid.target = frame.target;
  grid.time_s = (float(report.tick) + frame.alpha) * kTick_s;
  grid.unrest = lost * lost;
  grid.brightness = frame.brightness;
  grid_.draw(grid);

  SpriteFrame sprites;
  sprites.camera = view;
  sprites.target = frame.target;
  sprites.alpha = frame.alpha;
  sprites.tick = float(report.tick) + frame.alpha;
  sprites.brightness = frame.brightness;
  sprites_.draw(region, sprites);
  drawRings(run, rules, view, frame);
  stream_->end();

  GlCanvas canvas(quads_, text_, frame.target);
  screens(canvas);
  canvas.nextLayer();
}

void WorldView::drawRings(const Run& run, const Rules& rules, const Camera& camera, const WorldFrame& frame) {
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
    if (ring.radius_m > 0.1f) rings_.draw(ring, camera, frame.target);
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
    rings_.draw(ring, camera, frame.target);
  }
}

FollowCamera::Target cameraTarget(const TickReport& report, float alpha) {
  return {report.shipPrevious_x + (report.ship_x - report.shipPrevious_x) * alpha,
          report.shipPrevious_y + (report.ship_y - report.shipPrevious_y) * alpha, report.aim_rad,
          report.enemiesInView};
}

}  // namespace gw
