// What the keys do while a replay is watched: one line always, all of them beside the picture when it is paused.
#pragma once

#include <cstdint>

#include "game/ui/canvas.h"
#include "game/ui/key_hints.h"

namespace gw {

void drawViewerHints(Canvas& canvas, bool paused, const KeyHints& keys);
// The world stays visible: a pause is for looking.
void drawPausedTag(Canvas& canvas, uint32_t tick);
void drawViewerHelp(Canvas& canvas, const KeyHints& keys);

}  // namespace gw
