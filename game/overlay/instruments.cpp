#include "game/overlay/instruments.h"

#include <utility>

#include "game/overlay/overlay_panel.h"
#include "host/input/bindings.h"

namespace gw {

bool Instruments::handle(const SDL_Event& event) {
  if (event.type == SDL_KEYDOWN || event.type == SDL_KEYUP) {
    const uint32_t key = uint32_t(event.key.keysym.scancode);
    if (!isInstrumentKey(key)) return false;
    if (event.type == SDL_KEYUP || event.key.repeat != 0) return true;
    if (key == kKeyOverlay) shown_ = !shown_;
    if (key == kKeyColouring) ++colourings_;
    if (key == kKeyBroadPhase) ++switches_;
    return true;
  }
  return shown_ && imgui_ && imgui_->handle(event);
}

void Instruments::forget() {
  gatherer_.forget();
  frames_.clear();
  worked_s_ = 0;
}

void Instruments::work(Run& run, double now_s) {
  if (worked_s_ > 0) frames_.add((now_s - worked_s_) * 1000);
  worked_s_ = now_s;
  for (; colourings_ > 0; --colourings_) toggleColouring(now_s);
  for (; switches_ > 0; --switches_) {
    if (!make_) continue;
    notice_.say(switchBroadPhase(run, make_), now_s);
    gatherer_.forget();
  }
  Simulation& simulation = run.simulation();
  // Nothing else in a window times stages, so without the overlay they are not timed.
  if (simulation.timesStages() != shown_) simulation.enableStageTimes(shown_);
  if (shown_) gatherer_.look(simulation, now_s);
}

void Instruments::toggleColouring(double now_s) {
  const bool rows = colouring_ == Colouring::types;
  colouring_ = rows ? Colouring::rows : Colouring::types;
  notice_.say(rows ? "colours: by row of the grid" : "colours: by type", now_s);
}

void Instruments::drawOverlay(const TickReport& last, const Rules& rules, double realFps, bool pointer) {
  if (!shown_) return;
  if (!imgui_) imgui_ = std::make_unique<ImGuiLayer>(context_);
  imgui_->begin();
  drawOverlayPanel(gatherer_.figures(), {frames_, last, rules, realFps, colouring_, pointer});
  imgui_->end();
}

}  // namespace gw
