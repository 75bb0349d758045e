// One replay run again: what was compared, and what came of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "game/cli/verify_options.h"
#include "game/commands/run_facts.h"
#include "game/desync/desync_finder.h"
#include "game/session/device_choice.h"

namespace gw {

struct HashDifference {
  uint32_t tick = 0;
  uint64_t recorded = 0, actual = 0;
};

// What the hashes by field tell, which a replay keeps of every 60th tick.
struct FieldDifference {
  uint32_t tick = 0;  // the first kept one at or after the first difference
  std::vector<std::string> fields;
};

struct Outcome {
  std::string file, error, device, reference;  // reference: what it was played beside; empty: nothing
  ExitCode code = ExitCode::failedRun;
  uint32_t ticks = 0, compared = 0;
  double seconds = 0;
  std::optional<HashDifference> first;  // from the recording
  std::optional<FieldDifference> fields;
  std::optional<Desync> desync;   // from the reference
  uint64_t recordedAtDesync = 0;  // the replay's hash of its tick
  std::string desyncText;         // in words
  // Every tick equal, and yet the recorded result is another; or a snapshot that was restored is another snapshot.
  std::string wrong;
  std::vector<uint64_t> hashes;  // as computed
  RunFacts facts;
  SimulationConfig config;  // the replay's own
};

// Never throws: what goes wrong is in the outcome. `ticked` is told of every tick, on this thread.
Outcome verifyReplay(const std::filesystem::path& file, const VerifyOptions& options, const DeviceChoice& device,
                     const std::function<void()>& ticked);

}  // namespace gw
