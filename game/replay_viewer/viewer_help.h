// What the keys do while a replay is watched: one line always, all of them beside the picture when it is paused.
#pragma once

#include <cstdint>
#include <string>

#include "game/ui/canvas.h"
#include "game/ui/key_hints.h"

namespace gw {

// `banner` is what stands in the middle of the same line.
void drawViewerHints(Canvas& canvas, bool paused, const KeyHints& keys, const std::string& banner);
// The world stays visible: a pause is for looking.
void drawPausedTag(Canvas& canvas, uint32_t tick);
void drawViewerHelp(Canvas& canvas, const KeyHints& keys);

}  // namespace gw
