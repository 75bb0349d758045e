// The panel of the overlay, drawn with Dear ImGui.
#pragma once

#include "game/overlay/overlay_figures.h"
#include "host/overlay/frame_history.h"

namespace gw {

struct PanelFrame {
  const FrameHistory& frames;
  const TickReport& last;
  const Rules& rules;
  double realFps = 0;
  Colouring colouring{};
  bool pointer = false;  // the panel may be moved and folded
};

// Between ImGuiLayer::begin() and end().
void drawOverlayPanel(const OverlayFigures& figures, const PanelFrame& frame);

}  // namespace gw
