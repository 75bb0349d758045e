// Which screen comes next: a pure function of what was pressed and how the run stands.
#pragma once

namespace gw {

enum class Screen { title, play, pause, over, settings };
enum class FlowEvent { none, startRun, leaveRun, quitProgram };

struct FlowInput {
  bool confirm = false;   // Enter, space, click
  bool retry = false;     // R
  bool pause = false;     // Esc, P
  bool quit = false;      // Q
  bool settings = false;  // O
  bool settingsDone = false;
  bool lostFocus = false;
  bool lostPad = false;   // the controller in use went away
  bool botPlays = false;  // lost pads do not matter then
  bool inRun = false;     // a run waits: where the settings lead back to
  bool runOver = false;
  bool endsAlone = false;  // no look at the result, no further game
  double shown_s = 0;      // how long this screen has been shown
};

// A player who dies while hammering space or the mouse must not skip the result unseen.
inline constexpr double kOverGuard_s = 0.7;

// Moves `screen` on and says what to do about the run.
FlowEvent advance(Screen& screen, const FlowInput& input);

}  // namespace gw
