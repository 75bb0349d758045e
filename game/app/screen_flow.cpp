#include "game/app/screen_flow.h"

namespace gw {

namespace {

FlowEvent go(Screen& screen, Screen next, FlowEvent event) {
  screen = next;
  return event;
}

}  // namespace

FlowEvent advance(Screen& screen, const FlowInput& input) {
  switch (screen) {
    case Screen::title:
      if (input.confirm || input.retry) return go(screen, Screen::play, FlowEvent::startRun);
      if (input.settings) return go(screen, Screen::settings, FlowEvent::none);
      if (input.pause || input.quit) return FlowEvent::quitProgram;
      break;
    case Screen::play:
      if (input.runOver && input.endsAlone) return FlowEvent::quitProgram;
      if (input.runOver) return go(screen, Screen::over, FlowEvent::none);
      if (input.pause || (!input.botPlays && (input.lostFocus || input.lostPad)))
        return go(screen, Screen::pause, FlowEvent::none);
      break;
    case Screen::pause:
      if (input.retry) return go(screen, Screen::play, FlowEvent::startRun);
      if (input.pause || input.confirm) return go(screen, Screen::play, FlowEvent::none);
      if (input.settings) return go(screen, Screen::settings, FlowEvent::none);
      if (input.quit) return go(screen, Screen::title, FlowEvent::leaveRun);
      break;
    case Screen::settings:
      if (input.settingsDone) return go(screen, input.inRun ? Screen::pause : Screen::title, FlowEvent::none);
      break;
    case Screen::over:
      if (input.retry || (input.confirm && input.shown_s >= kOverGuard_s)) {
        return go(screen, Screen::play, FlowEvent::startRun);
      }
      // A pad's Start is both: within the guard it must not leave either.
      if (input.quit || (input.pause && !input.confirm)) return go(screen, Screen::title, FlowEvent::leaveRun);
      break;
  }
  return FlowEvent::none;
}

}  // namespace gw
