// Where the mouse aims. Canvas units.
#pragma once

#include "game/ui/canvas.h"

namespace gw {

void drawCrosshair(Canvas& canvas, float x, float y);

}  // namespace gw
