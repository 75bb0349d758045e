// bench/balance: how long bots live, what hurts them, and whether they ever wait.
//
//   build/release/gw_bench_balance --bot novice|expert [--seeds FROM:COUNT] [--mode arcade|deadline] [--jobs N]
//       [--max-seconds S] [--enemies N] [--rules FOLDER] [--csv FILE] [--out FILE.md]
//
// With --csv each finished run becomes a line there, and runs that stand there are not played again: stop it
// with Ctrl-C, start it again later. Figures are of game time and the same on every machine.
#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <exception>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "bench/balance_run.h"
#include "bench/balance_table.h"
#include "game/replay/checksum.h"
#include "game/replay/format.h"
#include "game/tables/tables.h"
#include "gpu/devices/processors.h"
#include "host/platform/interrupt.h"

namespace {

using namespace gw;

struct Request {
  std::string bot, mode = "arcade", csv, out, rules = GW_ASSETS_DIR;
  uint64_t firstSeed = 1, seeds = 20;
  uint32_t jobs = readProcessors().usable(), max_s = 900, enemies = 8192;
};

uint64_t number(std::string_view option, std::string_view text, uint64_t least, uint64_t most) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > most) {
    throw std::invalid_argument(std::string(option) + " takes a number from " + std::to_string(least) + " to " +
                                std::to_string(most) + ", not '" + std::string(text) + "'.");
  }
  return value;
}

Request parse(int argc, char** argv) {
  Request request;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view option = argv[i];
    if (i + 1 == argc) throw std::invalid_argument(std::string(option) + " needs a value.");
    const std::string_view value = argv[i + 1];
    if (option == "--bot") {
      request.bot = value;
    } else if (option == "--mode") {
      request.mode = value;
    } else if (option == "--seeds") {
      const size_t colon = value.find(':');
      if (colon == value.npos) throw std::invalid_argument("--seeds takes FROM:COUNT, such as 1:20.");
      request.firstSeed = number(option, value.substr(0, colon), 0, 1'000'000'000);
      request.seeds = number(option, value.substr(colon + 1), 1, 1'000'000);
    } else if (option == "--jobs") {
      request.jobs = uint32_t(number(option, value, 1, 256));
    } else if (option == "--max-seconds") {
      request.max_s = uint32_t(number(option, value, 1, kMaxTicks / kTicksPerSecond));
    } else if (option == "--enemies") {
      request.enemies = uint32_t(number(option, value, 1, kMaxEnemies));
    } else if (option == "--rules") {
      request.rules = value;
    } else if (option == "--csv") {
      request.csv = value;
    } else if (option == "--out") {
      request.out = value;
    } else {
      throw std::invalid_argument("There is no option '" + std::string(option) + "'; bench/balance.cpp lists them.");
    }
  }
  if (request.bot != "novice" && request.bot != "expert") throw std::invalid_argument("Name --bot novice or expert.");
  if (request.mode != "arcade" && request.mode != "deadline") {
    throw std::invalid_argument("--mode takes arcade or deadline.");
  }
  return request;
}

// Names rules by their text, so that runs of two versions of the tables are never mixed.
std::string fingerprint(const RuleTexts& texts) {
  const std::string all = texts.game.text + '\0' + texts.enemies.text + '\0' + texts.waves.text;
  char name[32];
  std::snprintf(name, sizeof name, "%016llx",
                (unsigned long long)replayChecksum({reinterpret_cast<const uint8_t*>(all.data()), all.size()}));
  return name;
}

// Plays all seeds that the file lacks; the file's runs are in order of finishing.
void playAll(const Request& request, const SimulationConfig& config, BalanceFile& file) {
  std::set<uint64_t> finished;
  for (const BalanceRun& run : file.runs()) finished.insert(run.seed);
  std::vector<uint64_t> seeds;
  for (uint64_t seed = request.firstSeed; seed < request.firstSeed + request.seeds; ++seed) {
    if (!finished.contains(seed)) seeds.push_back(seed);
  }
  std::atomic<size_t> next{0};
  std::atomic<bool> stop{false};
  std::mutex writing;
  std::exception_ptr failed;
  size_t done = 0;
  const auto work = [&] {
    try {
      for (size_t i = next++; i < seeds.size() && !stop; i = next++) {
        SimulationConfig mine = config;
        mine.seed = seeds[i];
        const auto run = playForBalance(mine, request.max_s * kTicksPerSecond, [&] { return stop || interrupted(); });
        if (!run) return;
        const std::lock_guard lock(writing);
        file.append(*run);
        std::fprintf(stderr, "%zu of %zu: seed %llu %s %.1f s, score %llu\n", ++done, seeds.size(),
                     (unsigned long long)run->seed, run->capped ? "was alive after" : "lived",
                     double(run->ticks) / kTicksPerSecond, (unsigned long long)run->score);
      }
    } catch (...) {
      const std::lock_guard lock(writing);
      failed = std::current_exception();
      stop = true;
    }
  };
  std::vector<std::thread> helpers;
  for (size_t i = 1; i < std::min<size_t>(request.jobs, seeds.size()); ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  if (failed) std::rethrow_exception(failed);
}

int balance(const Request& request) {
  const RuleTexts texts = readRuleTexts(request.rules);
  SimulationConfig config;
  config.rules = loadRules(texts);
  config.mode = request.mode == "deadline" ? Mode::deadline : Mode::arcade;
  config.autopilot = request.bot == "expert" ? Autopilot::expert : Autopilot::novice;
  config.enemies = request.enemies;
  const std::string title = request.bot + ", " + request.mode + ", at most " + std::to_string(request.max_s) + " s, " +
                            std::to_string(request.enemies) + " enemies fit, rules " + fingerprint(texts) +
                            ", simulation " + std::to_string(kSimulationVersion);
  BalanceFile file(request.csv, title, config.rules);
  playAll(request, config, file);
  std::vector<BalanceRun> asked;
  for (const BalanceRun& run : file.runs()) {
    if (run.seed >= request.firstSeed && run.seed - request.firstSeed < request.seeds) asked.push_back(run);
  }
  const std::string text = balanceSummary(title, config.rules, asked);
  std::fputs(text.c_str(), stdout);
  if (!request.out.empty() && !(std::ofstream(request.out) << text << std::flush)) {
    throw std::runtime_error("Cannot write " + request.out + "; name a folder that exists and can be written.");
  }
  return interrupted() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  catchInterrupts();
  try {
    return balance(parse(argc, argv));
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
