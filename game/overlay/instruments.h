// The instruments of a window: F3 shows the overlay, F4 colours entities by the row of the grid they stand in, F5 goes
// on with another broad phase. None of it changes the game.
#pragma once

#include <SDL_events.h>

#include <memory>

#include "game/overlay/broad_phase_switch.h"
#include "game/overlay/notice.h"
#include "game/overlay/overlay_figures.h"
#include "host/overlay/frame_history.h"
#include "host/overlay/imgui_layer.h"

namespace gw {

class Instruments {
 public:
  // Needs a current GL context of the window, which must outlive it. ImGui is not started before the first F3.
  explicit Instruments(SdlContext& context) : context_(context) {}

  // How to make another simulation; without it F5 does nothing.
  void makeBy(MakeSimulation make) { make_ = std::move(make); }

  // Is shown every event first; true: it goes no further. Those are the three keys, and what is pressed over the panel
  // while there is a pointer to press with.
  bool handle(const SDL_Event& event);

  // Another run begins.
  void forget();

  // Before a picture is drawn: does what the keys asked for, and looks at how the run is computed. No tick may be
  // queued.
  void work(Run& run, double now_s);
  Colouring colouring() const { return colouring_; }
  void drawNotice(Canvas& canvas, double now_s) const { notice_.draw(canvas, now_s); }
  // Over all else. pointer: there is one; in play the mouse is the ship's.
  void drawOverlay(const TickReport& last, const Rules& rules, double realFps, bool pointer);

 private:
  void toggleColouring(double now_s);

  SdlContext& context_;
  MakeSimulation make_;
  std::unique_ptr<ImGuiLayer> imgui_;
  bool shown_ = false;
  Colouring colouring_ = Colouring::types;
  uint32_t colourings_ = 0, switches_ = 0;  // asked for by key, not yet done
  FrameHistory frames_;
  double worked_s_ = 0;  // 0: not yet
  FigureGatherer gatherer_;
  Notice notice_;
};

}  // namespace gw
