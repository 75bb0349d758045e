#include "game/ui/crosshair.h"

#include "game/ui/theme.h"

namespace gw {

void drawCrosshair(Canvas& canvas, float x, float y) {
  const Rgba colour = theme::faded(theme::kAccent, 0.9f);
  for (const float side : {-1.0f, 1.0f}) {
    canvas.line(x + side * 5, y, x + side * 13, y, 1.5f, colour);
    canvas.line(x, y + side * 5, x, y + side * 13, 1.5f, colour);
  }
  canvas.rectangle(x - 1, y - 1, 2, 2, colour);
}

}  // namespace gw
