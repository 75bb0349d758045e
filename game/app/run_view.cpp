#include "game/app/run_view.h"

#include <algorithm>
#include <utility>

namespace gw {

RunView::RunView(const std::filesystem::path& assets, const Settings::Effects& effects)
    : renderer_(assets), effects_(effects) {}

void RunView::begin(Simulation& simulation) {
  camera_.emplace(simulation.worldWidth_m(), simulation.worldHeight_m());
}

CameraPlace RunView::cameraPlace() const {
  return camera_ ? CameraPlace{camera_->x(), camera_->y(), 2 * camera_->halfHeight_m()} : CameraPlace();
}

WorldPoint RunView::toWorld(float x_px, float y_px, const EventArea& area) const {
  WorldPoint place;
  if (camera_) camera_->toWorld(x_px, y_px, area.width, area.height, place.x, place.y);
  return place;
}

CanvasPoint RunView::toCanvas(WorldPoint place, float canvasWidth) const {
  CanvasPoint point;
  if (camera_) camera_->toPixels(place.x, place.y, canvasWidth, Canvas::kHeight, point.x, point.y);
  return point;
}

void RunView::moveCamera(Run& run, const FrameClock& clock, const FixedTimestep& timestep, float aspect) {
  if (run.last().tick == 0 && !place_) {
    // There is no report yet, so the position of the ship is not known: the middle of the world.
    camera_->snap({run.simulation().worldWidth_m() / 2, run.simulation().worldHeight_m() / 2, 0, 0}, aspect);
    return;
  }
  const FollowCamera::Target target = cameraTarget(run.last(), timestep.alpha());
  const bool cut = std::exchange(cut_, false);
  const double passed_s = timestep.paused() ? 0 : clock.now_s() - (drawn_s_ == 0 ? clock.previous_s() : drawn_s_);
  drawn_s_ = clock.now_s();
  if (place_) {
    camera_->place(*place_, aspect);
  } else if (cut) {
    camera_->snap(target, aspect);
  } else {
    camera_->follow(target, aspect, float(passed_s * std::max(1.0, timestep.speed())));  // a fast ship stays in view
  }
}

void RunView::draw(Run& run, const Rules& rules, const FrameClock& clock, const FixedTimestep& timestep,
                   const RunViewFrame& view, const WorldRenderer::Screens& screens) {
  const float aspect = float(std::max(view.target.width, 1)) / float(std::max(view.target.height, 1));
  moveCamera(run, clock, timestep, aspect);
  if (!run.over()) overSince_s_ = 0;
  if (run.over() && overSince_s_ == 0) overSince_s_ = clock.now_s();
  WorldFrame frame{view.target, timestep.alpha(), view.brightness};
  frame.afterEnd_ticks = run.over() ? float((clock.now_s() - overSince_s_) * kTicksPerSecond) : 0;
  frame.effects = effects_;
  if (timestep.speed() > 1) frame.effects.flash = 0;  // flashes would repeat faster than is safe for the eyes
  frame.colouring = view.colouring;
  renderer_.draw(run, rules, *camera_, frame, screens);
}

}  // namespace gw
