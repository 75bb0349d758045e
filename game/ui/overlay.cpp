#include "game/ui/overlay.h"

#include "game/ui/theme.h"
#include "host/platform/number_format.h"

namespace gw {

namespace {

constexpr float kEdge = 120;  // how far the light reaches in from the edges
constexpr int kStrips = 12;   // a canvas fades from left to right only: downwards it takes strips

}  // namespace

void drawFlash(Canvas& canvas, const FlashLight& light) {
  if (light.colour.alpha <= 0) return;
  if (!light.edge) {
    canvas.rectangle(0, 0, canvas.width(), Canvas::kHeight, light.colour);
    return;
  }
  const Rgba none = theme::faded(light.colour, 0);
  canvas.gradient(0, 0, kEdge, Canvas::kHeight, light.colour, none);
  canvas.gradient(canvas.width() - kEdge, 0, kEdge, Canvas::kHeight, none, light.colour);
  constexpr float kStrip = kEdge / kStrips;
  for (int i = 0; i < kStrips; ++i) {
    const Rgba colour = theme::faded(light.colour, 1 - (float(i) + 0.5f) / kStrips);
    canvas.rectangle(0, kStrip * float(i), canvas.width(), kStrip, colour);
    canvas.rectangle(0, Canvas::kHeight - kStrip * float(i + 1), canvas.width(), kStrip, colour);
  }
}

void drawScorePops(Canvas& canvas, std::span<const ScorePops::Shown> pops, const Camera& camera, float brightness) {
  for (const ScorePops::Shown& pop : pops) {
    const float x = ((pop.x - camera.centre_x) / camera.halfWidth_m + 1) / 2 * canvas.width();
    const float y = (1 - (pop.y - camera.centre_y) / camera.halfHeight_m) / 2 * Canvas::kHeight;
    const Rgba colour = theme::mixed(theme::kGold, theme::kText, (pop.size - 10) / 16);
    canvas.text(
        withCommas(pop.points), x, y + pop.size / 2,
        theme::style(pop.size, theme::faded(colour, 0.85f * pop.opacity * brightness), TextAlign::centre, 0.25f));
  }
}

}  // namespace gw
