// Every CUDA call of a game fails once, in every way that counts: the game begins or goes on with the cpu device, with
// the same hash at every tick, and says so in one sentence. The table in docs/reference/cuda-faults.md is what was seen
// here.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "game/session/device_choice.h"
#include "game/tables/tables.h"
#include "host/platform/user_error.h"
#include "stand_in.h"

namespace gw {
namespace {

constexpr uint32_t kTicks = 64;    // past the first snapshot
constexpr size_t kFirstTicks = 2;  // which part of the game they are: after choosing and starting

SimulationConfig config() {
  SimulationConfig config;
  config.rules = loadRules(readRuleTexts(GW_ASSETS_DIR));
  config.enemies = 64;
  config.mode = Mode::swarm;
  config.autopilot = Autopilot::expert;
  config.threads = 1;
  config.particles = true;
  return config;
}

struct Seen {
  std::string struck;   // the call that failed; empty: it was never made
  std::string moment;   // in which part of the game
  std::string outcome;  // what the player sees
  std::vector<uint64_t> hashes;
};

// The whole life of a game, as a player with --device auto has it. `parts`: after how many calls each part of it ended.
Seen playThrough(const stand_in::Options& options, std::vector<uint64_t>* parts = nullptr) {
  stand_in::restart(options);
  Seen seen;
  const auto at = [&](const char* moment) {
    if (seen.struck.empty()) seen.moment = moment;
    seen.struck = stand_in::struck();
  };
  testing::internal::CaptureStderr();
  const DeviceChoice device = chooseDevice(DeviceOption::automatic);
  at("choosing a device");
  if (parts) parts->push_back(stand_in::calls());
  if (!device.why.empty()) seen.outcome = device.why;
  const std::unique_ptr<Simulation> game = makeLastingSimulation(device, config());
  at("starting the game");
  if (parts) parts->push_back(stand_in::calls());
  for (uint32_t t = 0; t < kTicks; ++t) {
    game->tick({});
    seen.hashes.push_back(game->report().hash);
    at("playing");
    // The first ticks, those before the first snapshot, it, and what comes after it.
    if (parts && (t == 1 || t == 58 || t == kTicks - 1)) parts->push_back(stand_in::calls());
    if (!seen.struck.empty() && seen.moment != "playing" && t > 2) break;  // the cpu device is tested elsewhere
  }
  game->enableStageTimes(true);
  game->tick({});
  seen.hashes.push_back(game->report().hash);
  game->enableStageTimes(false);
  at("timing stages");
  if (parts) parts->push_back(stand_in::calls());
  game->countCandidates();
  game->inspect(20, 20, 50);
  at("inspecting");
  if (parts) parts->push_back(stand_in::calls());
  std::string said = testing::internal::GetCapturedStderr();
  if (!said.empty() && said.back() == '\n') said.pop_back();
  if (seen.outcome.empty()) seen.outcome = said;
  if (seen.outcome.empty() && device.cuda) seen.outcome = "nothing";
  return seen;
}

const std::vector<uint64_t>& expected() {
  static const std::vector<uint64_t> hashes = [] {
    std::vector<uint64_t> made;
    const auto game = cpu::makeSimulation(config());
    for (uint32_t t = 0; t < kTicks + 1; ++t) {
      game->tick({});
      made.push_back(game->report().hash);
    }
    return made;
  }();
  return hashes;
}

void expectTheSameGame(const Seen& seen, const std::string& what) {
  const size_t ticks = seen.hashes.size();
  ASSERT_GT(ticks, 2u);
  // A game that has been cut short has its last tick at the end all the same.
  const std::vector<uint64_t> part(expected().begin(), expected().begin() + ptrdiff_t(ticks));
  EXPECT_EQ(seen.hashes, part) << what;
}

// Which calls to let fail: of each part of the game the first and the last of each kind.
std::vector<uint64_t> callsToFail(const std::vector<uint64_t>& parts, const std::vector<std::string>& log) {
  std::set<uint64_t> chosen;
  uint64_t begin = 0;
  for (const uint64_t end : parts) {
    std::map<std::string, std::vector<uint64_t>> byName;
    for (uint64_t call = begin; call < end; ++call) byName[log[call]].push_back(call + 1);
    for (const auto& [name, calls] : byName) chosen.insert({calls.front(), calls.back()});
    begin = end;
  }
  return {chosen.begin(), chosen.end()};
}

// Without what depends on the error: its name, and the remedy for it.
std::string inGeneral(const std::string& outcome) {
  return std::regex_replace(outcome, std::regex(R"( \(([^)]*)\): [^.]*\.)"), " (*why*): *remedy*.");
}

TEST(Fault, AGameWithoutOnesRunsOnCudaAndIsTheSame) {
  for (const stand_in::Options& options :
       {stand_in::Options{}, stand_in::Options{.eager = true}, stand_in::Options{.reversed = true}}) {
    const Seen seen = playThrough(options);
    expectTheSameGame(seen, "no fault");
    EXPECT_EQ(seen.outcome, "nothing");
    EXPECT_GT(stand_in::kernelsRun(), 1000u);
  }
}

TEST(Fault, ATickOfACapturedGameIsAsManyLaunchesAsOnCpu) {
  stand_in::restart({});
  const auto onCuda = cuda::makeSimulation(config());
  const auto onCpu = cpu::makeSimulation(config());
  for (Simulation* game : {onCuda.get(), onCpu.get()}) {
    game->tick({});
    game->report();
  }
  EXPECT_EQ(onCuda->launchesPerTick(), onCpu->launchesPerTick());
}

TEST(Fault, NoneEndsOrChangesTheGame) {
  std::vector<uint64_t> parts;
  playThrough({}, &parts);
  const std::vector<std::string> log = stand_in::callLog();
  std::set<std::string> made;
  for (const auto& [call, times] : stand_in::callsByName()) made.insert(call);

  std::set<std::string> struck;
  std::map<std::pair<std::string, std::string>, std::set<std::string>> table;  // moment, outcome: calls
  for (const cudaError_t error : {cudaErrorMemoryAllocation, cudaErrorLaunchFailure}) {
    for (const uint64_t call : callsToFail(parts, log)) {
      // Deep in a game both errors go the same way.
      if (error == cudaErrorMemoryAllocation && call > parts[kFirstTicks]) break;
      stand_in::Options options;
      options.fault = {"*", call, error};
      const Seen seen = playThrough(options);
      const std::string what = "call " + std::to_string(call) + " (" + seen.struck + ")";
      EXPECT_FALSE(seen.struck.empty()) << what;
      expectTheSameGame(seen, what);
      EXPECT_NE(seen.outcome, "") << what;
      EXPECT_EQ(std::count(seen.outcome.begin(), seen.outcome.end(), '\n'), 0) << what << ": " << seen.outcome;
      struck.insert(seen.struck);
      table[{seen.moment, inGeneral(seen.outcome)}].insert(seen.struck);
    }
  }
  // What only releases, or asks after an error, has no caller to tell.
  for (const char* silent :
       {"cudaFree", "cudaFreeHost", "cudaStreamDestroy", "cudaEventDestroy", "cudaGraphExecDestroy"}) {
    made.erase(silent);
    struck.erase(silent);
  }
  EXPECT_EQ(struck, made);

  std::ofstream out(GW_FAULT_TABLE);
  out << "| When | Call that failed | What the player sees |\n|---|---|---|\n";
  for (const auto& [row, calls] : table) {
    out << "| " << row.first << " |";
    for (const std::string& call : calls) out << (call == *calls.begin() ? " " : ", ") << '`' << call << '`';
    out << " | " << row.second << " |\n";
  }
}

TEST(Fault, TheTableInTheDocsIsWhatWasSeen) {
  const auto text = [](const char* path) {
    std::stringstream all;
    all << std::ifstream(path).rdbuf();
    return all.str();
  };
  EXPECT_NE(text(GW_FAULT_DOCS).find(text(GW_FAULT_TABLE)), std::string::npos)
      << "copy " << GW_FAULT_TABLE << " into docs/reference/cuda-faults.md";
}

TEST(Fault, AMachineThatCannotIsToldSoAtOnce) {
  for (const auto& [call, error, sentence] :
       {std::tuple{"cudaGetDeviceCount", cudaErrorInsufficientDriver, "driver"},
        std::tuple{"cudaGetDeviceCount", cudaErrorNoDevice, "device"},
        std::tuple{"cudaMalloc", cudaErrorMemoryAllocation, "choose a smaller --enemies"},
        std::tuple{"cudaLaunchKernelEx", cudaErrorNoKernelImageForDevice, "build GpuWars for this GPU"}}) {
    stand_in::Options options;
    options.fault = {call, 1, error};
    const Seen seen = playThrough(options);
    EXPECT_EQ(seen.struck, call);
    EXPECT_NE(seen.outcome.find(sentence), std::string::npos) << seen.outcome;
    expectTheSameGame(seen, call);
  }
}

TEST(Fault, WhoChecksLaunchesIsToldWhichKernelFailed) {
  SimulationConfig checked = config();
  checked.checkLaunches = true;
  stand_in::restart({});
  {
    const auto game = cuda::makeSimulation(checked);
    for (uint32_t t = 0; t < 5; ++t) {
      game->tick({});
      EXPECT_EQ(game->report().hash, expected()[t]);
    }
    EXPECT_EQ(stand_in::callsByName().count("cudaGraphLaunch"), 0u);
  }
  const uint64_t waits = stand_in::callsByName().at("cudaStreamSynchronize");
  std::set<std::string> named;
  for (uint64_t wait = waits / 2; wait < waits / 2 + 40; ++wait) {
    stand_in::restart({.fault = {"cudaStreamSynchronize", wait, cudaErrorIllegalAddress}});
    try {
      const auto game = cuda::makeSimulation(checked);
      for (uint32_t t = 0; t < 5; ++t) {
        game->tick({});
        game->report();
      }
    } catch (const DeviceError& error) {
      std::smatch kernel;
      const std::string text = error.what();
      if (std::regex_search(text, kernel,
                            std::regex(R"(running the kernel gw::cuda::(?:\(anonymous namespace\)::)?(\w+))"))) {
        named.insert(kernel[1]);
      }
    }
  }
  EXPECT_TRUE(named.count("Integrate") && named.count("GameLogic") && named.count("Think"))
      << testing::PrintToString(named);
}

TEST(Fault, CudaAskedForByNameIsNotReplacedByAnother) {
  stand_in::Options options;
  options.fault = {"cudaMalloc", 3, cudaErrorMemoryAllocation};
  stand_in::restart(options);
  const DeviceChoice device = chooseDevice(DeviceOption::cuda);
  EXPECT_THROW(makeLastingSimulation(device, config()), UserError);
}

TEST(Fault, ADeviceThatWasLostIsNotTriedAgain) {
  stand_in::Options options;
  options.fault = {"cudaGraphLaunch", 3, cudaErrorIllegalAddress};
  stand_in::restart(options);
  const DeviceChoice device = chooseDevice(DeviceOption::automatic);
  testing::internal::CaptureStderr();
  const auto first = makeLastingSimulation(device, config());
  for (int t = 0; t < 5; ++t) {
    first->tick({});
    first->report();
  }
  EXPECT_FALSE(first->onCuda());
  EXPECT_NE(testing::internal::GetCapturedStderr(), "");
  testing::internal::CaptureStderr();
  EXPECT_FALSE(makeLastingSimulation(device, config())->onCuda());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace gw
