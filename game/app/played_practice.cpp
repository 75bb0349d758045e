#include "game/app/played_practice.h"

#include "game/ui/practice_panel.h"

namespace gw {

void PlayedPractice::take(PlayerInput& keys) {
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

void PlayedPractice::step(Screen screen, GameLoop& loop, Run& run) {
  constexpr float kReach_m = 3;
  if (screen == Screen::play) practice_.press(presses_);
  loop.pacer().setSpeed(practice_.speed());
  if (screen != Screen::pause) {
    inspected_.reset();
  } else if (clicked_) {
    const WorldPoint place = loop.underPointer();
    inspected_ = run.simulation().inspect(place.x, place.y, kReach_m);
  }
}

void PlayedPractice::drawPanel(Canvas& canvas, const Rules& rules, const KeyHints& keys) const {
  drawPracticePanel(canvas, rules,
                    {practice_.type(), kPracticeCounts[practice_.number()], practice_.slow(), true, keys});
}

void PlayedPractice::drawPause(Canvas& canvas, const Rules& rules, const KeyHints& keys, bool lostPad,
                               const GameLoop& loop) const {
  std::optional<Inspected> inspected;
  if (inspected_) {  // where it is drawn: between its last two places
    const EntityRecord& e = *inspected_;
    const float alpha = loop.pacer().alpha();
    const CanvasPoint at =
        loop.onCanvas({e.previous_x + (e.x - e.previous_x) * alpha, e.previous_y + (e.y - e.previous_y) * alpha});
    inspected = Inspected{e, at.x, at.y};
  }
  drawPracticePause(canvas, rules, keys, lostPad, inspected);
}

}  // namespace gw
