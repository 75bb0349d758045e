// Effects that are drawn as shapes and text. They belong under everything that lives.
#pragma once

#include <span>

#include "game/effects/flash.h"
#include "game/effects/score_pops.h"
#include "game/ui/canvas.h"

namespace gw {

void drawFlash(Canvas& canvas, const FlashLight& light);

void drawScorePops(Canvas& canvas, std::span<const ScorePops::Shown> pops, const Camera& camera, float brightness);

}  // namespace gw
