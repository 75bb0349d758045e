// How a simulation is computed: the options of every verb that runs one.
#pragma once

#include <filesystem>
#include <optional>

#include "game/sim/simulation.h"

namespace gw {

class OptionSet;

enum class DeviceOption : uint32_t { automatic, cuda, cpu };

// Whose rules decide how the NGrid is asked.
enum class GameSource { ownGame, replay };

struct ComputingOptions {
  // None of these can change the game.
  DeviceOption device = DeviceOption::automatic;
  uint32_t threads = 0;  // cpu device: 0 takes one per processor that it may use
  BroadPhase broadPhase = BroadPhase::ngrid;
  VisitOrder order = VisitOrder::forward;
  bool protectMemory = false;
  bool cudaCheck = false;
  uint32_t blockSize = 128;  // cuda device

  // None: not asked for, so what a replay says, else exact, and usualSort(). Inexact gathers change the game; a replay
  // cannot be asked for others than it was recorded with.
  std::optional<Gather> gather;
  std::optional<Sort> sort;
  bool thesis = false;  // they were asked for by --thesis

  std::filesystem::path assetsDir;  // of shaders and rule tables; empty: where the program finds its own

  // `usual`: whose gather and sort the help names as those that hold without the options.
  void declareComputing(OptionSet& options, GameSource usual);
  // Expands --thesis. Throws UsageError at the first contradiction; what a replay says is checked when it is open.
  void checkComputing(GameSource source);
};

// The words of the command line.
const char* nameOf(BroadPhase broadPhase);
const char* nameOf(Gather gather);
const char* nameOf(Sort sort);

}  // namespace gw
