// The whole command line (docs and scripts depend on it), parsed into plain data. Nothing is opened,
// run or printed here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "game/cli/scene_kind.h"
#include "game/sim/simulation.h"
#include "host/platform/exit_code.h"

namespace gw {

enum class Verb : uint32_t { play, replay, verify, render, profile, trim, diff, devices, probe };
enum class DeviceOption : uint32_t { automatic, cuda, cpu };

struct Options {
  Verb verb = Verb::play;

  // The game (play).
  Mode mode = Mode::arcade;
  std::optional<uint64_t> seed;  // none: headless runs take 1, windows a new one each time
  uint32_t enemies = 8192;
  Autopilot autopilot = Autopilot::none;

  // How neighbours are found (play, replay, verify, trim). None: not asked for, so what a replay says, else exact, and
  // usualSort(). Inexact gathers change the game; a replay cannot be asked for others than it was recorded with.
  std::optional<Gather> gather;
  std::optional<Sort> sort;
  bool thesis = false;  // they were asked for by --thesis

  // How it is computed (play, replay, verify, trim). Cannot change the game.
  DeviceOption device = DeviceOption::automatic;
  uint32_t threads = 0;  // cpu device: 0 takes one per processor that it may use
  BroadPhase broadPhase = BroadPhase::ngrid;
  VisitOrder order = VisitOrder::forward;
  bool protectMemory = false;
  bool cudaCheck = false;
  uint32_t blockSize = 128;  // cuda device

  // The run (play).
  bool headless = false;
  uint32_t ticks = 0;                    // 0: until the game is over; never 0 when headless
  std::filesystem::path recordPath;      // empty: none; so for all paths
  std::filesystem::path screenshotPath;  // headless: PNG of the last tick

  // The window (play, replay); also the size of a screenshot.
  uint32_t width_px = 1280, height_px = 720;
  bool fullscreen = false;
  bool mute = false;
  std::filesystem::path settingsPath;  // empty: the usual place

  // replay
  double speed = 1;        // times real time
  bool quitAtEnd = false;  // it leaves by itself

  // replay, render
  std::optional<uint32_t> fromTick;

  // trim, and render: a folder, or a file that ends in .png or .mp4
  std::filesystem::path outPath;
  uint32_t toTick = 0;  // 0: all there are

  // render
  uint32_t framesPerSecond = 60;  // of game time
  bool hud = true;

  // profile; outPath is the folder, ticks the length of a run
  profile::SceneKind scene = profile::SceneKind::fiveMinutes;
  bool sceneAsked = false;
  std::filesystem::path replayPath;   // instead of a scene
  std::vector<uint32_t> enemiesList;  // empty: `enemies` alone
  uint32_t seconds = 0;               // another way to say ticks
  std::string compare;                // contenders, with commas; empty: broadPhase alone
  uint32_t runs = 10;                 // of each contender
  bool drawNothing = false;           // simulation only
  bool paced = false;                 // ticks in real time
  bool effects = true;                // particles, flashes, bending, shake
  float glow = 0.5f;                  // Settings::Effects::glow
  bool wholeWorld = false;            // is drawn, and not what a player sees
  std::filesystem::path tracePath;
  std::filesystem::path baselinePath;  // an earlier report.json

  // replay, render and trim (exactly one), diff (two), verify (one or more)
  std::vector<std::filesystem::path> files;

  // verify
  uint32_t jobs = 1;                    // replays at the same time
  bool heavy = false;                   // every tick's state is taken as a snapshot and restored
  std::optional<DeviceOption> against;  // another device plays beside
  std::filesystem::path reference;      // another program plays beside; empty: none
  std::string referenceOptions;         // its own, with spaces between them
  std::filesystem::path junitPath;      // the results for continuous integration

  std::filesystem::path jsonPath;    // verify, diff, devices; "-" is stdout
  std::filesystem::path hashesPath;  // headless play, verify: one line a tick; "-" is stdout
  std::filesystem::path assetsDir;   // empty: where the program finds its own

  std::string text;  // the command line as given, for a replay's header
};

struct ParsedCommandLine {
  bool run = false;  // false: say the texts below and exit with `code`
  Options options;
  ExitCode code = ExitCode::fine;
  std::string output;  // for stdout: help, version; ends in a newline
  std::string error;   // for stderr: one sentence with a remedy, no newline
};

// The words of the command line.
const char* nameOf(BroadPhase broadPhase);
const char* nameOf(Gather gather);
const char* nameOf(Sort sort);

// `arguments` without the program's name. Never throws on what a user can pass.
ParsedCommandLine parseCommandLine(const std::vector<std::string>& arguments);

}  // namespace gw
