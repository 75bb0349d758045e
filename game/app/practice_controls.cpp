#include "game/app/practice_controls.h"

#include "game/ui/practice_panel.h"

namespace gw {

void PracticeControls::take(PlayerInput& keys) {
  const auto count = [&](Action action) {
    int times = 0;
    while (keys.pressed(action)) ++times;
    return times;
  };
  presses_.number = keys.number();
  presses_.nextType = count(Action::nextType);
  presses_.more = count(Action::more) - count(Action::fewer) + keys.wheel();
  presses_.spawn = count(Action::spawn);
  presses_.clear = count(Action::clear);
  presses_.slowMotion = count(Action::slowMotion);
  clicked_ = keys.clicked();
}

void PracticeControls::update(Screen screen, FixedTimestep& timestep, Run& run, WorldPoint pointer) {
  constexpr float kReach_m = 3;
  if (screen == Screen::play) practice_.press(presses_);
  timestep.setSpeed(practice_.speed());
  if (screen != Screen::pause) {
    inspected_.reset();
  } else if (clicked_) {
    inspected_ = run.simulation().inspect(pointer.x, pointer.y, kReach_m);
  }
}

void PracticeControls::drawPanel(Canvas& canvas, const Rules& rules, const KeyHints& keys) const {
  drawPracticePanel(canvas, rules,
                    {practice_.type(), kPracticeCounts[practice_.number()], practice_.slow(), true, keys});
}

void PracticeControls::drawPause(Canvas& canvas, const Rules& rules, const KeyHints& keys, bool lostPad,
                                 const AppServices& services) const {
  std::optional<Inspected> inspected;
  if (inspected_) {  // drawn between its last two positions
    const EntityRecord& e = *inspected_;
    const float alpha = services.timestep.alpha();
    const CanvasPoint at = services.view.toCanvas(
        {e.previous_x + (e.x - e.previous_x) * alpha, e.previous_y + (e.y - e.previous_y) * alpha},
        services.window.canvasWidth());
    inspected = Inspected{e, at.x, at.y};
  }
  drawPracticePause(canvas, rules, keys, lostPad, inspected);
}

}  // namespace gw
