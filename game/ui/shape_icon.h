// The shapes of the enemy types, small, as lines: on screens too no type is told apart by colour alone.
#pragma once

#include "game/sim/rules.h"
#include "game/ui/canvas.h"

namespace gw {

// Within `radius` of (x, y).
void drawShapeIcon(Canvas& canvas, Shape shape, float x, float y, float radius, Rgba colour);

}  // namespace gw
