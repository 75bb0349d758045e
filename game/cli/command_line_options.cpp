#include "game/cli/command_line_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "game/replay/format.h"

namespace gw {
namespace {

constexpr Choice kModes[] = {{"arcade", uint32_t(Mode::arcade)},
                             {"deadline", uint32_t(Mode::deadline)},
                             {"swarm", uint32_t(Mode::swarm)},
                             {"practice", uint32_t(Mode::practice)}};
constexpr Choice kDevices[] = {{"auto", uint32_t(DeviceOption::automatic)},
                               {"cuda", uint32_t(DeviceOption::cuda)},
                               {"cpu", uint32_t(DeviceOption::cpu)}};
constexpr Choice kAgainst[] = {{"cuda", uint32_t(DeviceOption::cuda)}, {"cpu", uint32_t(DeviceOption::cpu)}};
constexpr Choice kBroadPhases[] = {{"ngrid", uint32_t(BroadPhase::ngrid)},
                                   {"grid", uint32_t(BroadPhase::grid)},
                                   {"grid-hashed", uint32_t(BroadPhase::gridHashed)},
                                   {"brute", uint32_t(BroadPhase::bruteForce)}};
constexpr Choice kGathers[] = {
    {"exact", uint32_t(Gather::exact)}, {"adaptive", uint32_t(Gather::adaptive)}, {"fixed", uint32_t(Gather::fixed)}};
constexpr Choice kSorts[] = {{"bitonic", uint32_t(Sort::bitonic)},
                             {"odd-even", uint32_t(Sort::oddEven)},
                             {"full", uint32_t(Sort::full)},
                             {"frozen", uint32_t(Sort::frozen)}};
constexpr Choice kAutopilots[] = {{"novice", uint32_t(Autopilot::novice)}, {"expert", uint32_t(Autopilot::expert)}};
constexpr Choice kFrameRates[] = {{"30", 30}, {"60", 60}, {"120", 120}};
constexpr Choice kHud[] = {{"on", 1}, {"off", 0}};
constexpr Choice kOrders[] = {{"forward", uint32_t(VisitOrder::forward)},
                              {"reversed", uint32_t(VisitOrder::reversed)},
                              {"shuffled", uint32_t(VisitOrder::shuffled)}};

constexpr Choice kScenes[] = {{"five-minutes", uint32_t(profile::SceneKind::fiveMinutes)},
                              {"ramp", uint32_t(profile::SceneKind::ramp)},
                              {"swarm", uint32_t(profile::SceneKind::swarm)},
                              {"menu", uint32_t(profile::SceneKind::menu)}};
constexpr Choice kEffects[] = {{"on", 1}, {"off", 0}};
constexpr Choice kGlows[] = {{"off", 0}, {"low", 1}, {"high", 2}};
constexpr Choice kLooks[] = {{"player", 0}, {"world", 1}};

constexpr const char* kDiagnostics = "Diagnostics";
constexpr uint32_t kLeastProfiledTicks = 60;

// Numbers of enemies, with commas.
std::vector<uint32_t> enemiesIn(const std::string& list) {
  std::vector<uint32_t> counts;
  for (size_t begin = 0; begin <= list.size();) {
    const size_t end = std::min(list.find(',', begin), list.size());
    const std::string word = list.substr(begin, end - begin);
    uint32_t count = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || stop != word.data() + word.size() || count < 1 || count > kMaxEnemies) {
      throw UsageError(fmt::format("'--enemies {}' does not work; give whole numbers from 1 to {}, separated by commas",
                                   list, kMaxEnemies));
    }
    if (std::find(counts.begin(), counts.end(), count) != counts.end()) {
      throw UsageError(fmt::format("'--enemies {}' names {} twice; once is enough", list, count));
    }
    counts.push_back(count);
    begin = end + 1;
  }
  return counts;
}

// The word among an option's that stands for a value.
template <size_t kCount>
const char* wordFor(const Choice (&choices)[kCount], uint32_t value) {
  for (const Choice& choice : choices) {
    if (choice.value == value) return choice.name.data();  // a literal: it ends in a zero
  }
  return "?";
}

}  // namespace

VerbOptions::VerbOptions(CommandLineValues& values, Options& options) : values_(values), options_(options) {
  const Verb verb = options_.verb;
  if (verb == Verb::play) addGame();
  if (verb != Verb::devices && verb != Verb::diff) addComputing();
  if (verb == Verb::play || verb == Verb::replay) addWindow();
  if (verb == Verb::render) addRender();
  if (verb == Verb::replay) addReplay();
  if (verb == Verb::verify) addVerify();
  if (verb == Verb::trim) addTrim();
  if (verb == Verb::diff) addDiff();
  if (verb == Verb::devices) addDevices();
  if (verb == Verb::probe) addProbe();
  if (verb == Verb::profile) addProfile();
}

void VerbOptions::addGame() {
  values_.choice("--mode", kModes, "the game", "arcade", [&](uint32_t v) { options_.mode = Mode(v); });
  values_.integer("--seed", "seed of the game; by default 1 when headless, else a new one each time", 0, UINT64_MAX,
                  [&](uint64_t v) { options_.seed = v; });
  values_.integer("--enemies", "how many live enemies fit (8192)", 1, kMaxEnemies,
                  [&](uint64_t v) { options_.enemies = uint32_t(v); });
  values_.choice("--autopilot", kAutopilots, "who plays instead of you", "no bot",
                 [&](uint32_t v) { options_.autopilot = Autopilot(v); });
  values_.integer("--ticks", "end after so many ticks of 1/60 s", 1, kMaxTicks,
                  [&](uint64_t v) { options_.ticks = uint32_t(v); });
  values_.flag("--headless", "no window, no waiting: as fast as it goes", [&] { options_.headless = true; });
  values_.path("--record", "write a replay to FILE", "FILE", [&](std::string v) { options_.recordPath = v; });
  values_.path("--hashes", "headless: write one line a tick to OUT ('-': stdout)", "OUT",
               [&](std::string v) { options_.hashesPath = v; });
  values_.path(
      "--screenshot", "headless: write the last tick's picture to FILE (PNG)", "FILE",
      [&](std::string v) { options_.screenshotPath = v; }, kDiagnostics);
}

void VerbOptions::addComputing() {
  values_.choice("--device", kDevices, "what computes", "auto", [&](uint32_t v) { options_.device = DeviceOption(v); });
  values_.integer("--threads", "worker threads of the cpu device (0: one per processor that it may use)", 0, 256,
                  [&](uint64_t v) { options_.threads = uint32_t(v); });
  values_.choice("--broad-phase", kBroadPhases, "how neighbours are found; cannot change the game", "ngrid",
                 [&](uint32_t v) { options_.broadPhase = BroadPhase(v); });
  const bool play = options_.verb == Verb::play;
  values_.choice("--gather", kGathers, "how the NGrid is asked; adaptive and fixed miss some, in a game of their own",
                 play ? "exact" : "the replay's", [&](uint32_t v) { options_.gather = Gather(v); });
  values_.choice("--sort", kSorts, "how the NGrid is kept in order",
                 play ? "frozen, or bitonic where a gather is inexact" : "the replay's where it matters, else frozen",
                 [&](uint32_t v) { options_.sort = Sort(v); });
  values_.flag("--thesis", "the thesis's own NGrid: --gather adaptive --sort bitonic", [&] { options_.thesis = true; });
  values_.choice(
      "--order", kOrders, "in which order the cpu device visits items", "forward",
      [&](uint32_t v) { options_.order = VisitOrder(v); }, kDiagnostics);
  values_.flag(
      "--protect-memory", "the cpu device's memory is unreadable outside launches and copies",
      [&] { options_.protectMemory = true; }, kDiagnostics);
  values_.integer(
      "--block-size", "threads per block of the cuda device (128)", 32, 1024,
      [&](uint64_t v) {
        if (v % 32 != 0) {
          throw UsageError(fmt::format("'--block-size {}' does not work; give a multiple of 32 from 32 to 1024", v));
        }
        options_.blockSize = uint32_t(v);
      },
      kDiagnostics);
  values_.flag(
      "--cuda-check", "the cuda device waits for every launch and says which one failed; slow",
      [&] { options_.cudaCheck = true; }, kDiagnostics);
  values_.path(
      "--assets", "folder of shaders and rule tables", "DIR", [&](std::string v) { options_.assetsDir = v; },
      kDiagnostics);
}

void VerbOptions::addSize() {
  values_.integer("--width", "of the window or picture, in pixels (1280)", 320, 7680,
                  [&](uint64_t v) { options_.width_px = uint32_t(v); });
  values_.integer("--height", "of the window or picture, in pixels (720)", 200, 4320,
                  [&](uint64_t v) { options_.height_px = uint32_t(v); });
}

void VerbOptions::addWindow() {
  addSize();
  values_.flag("--fullscreen", "fill the screen", [&] { options_.fullscreen = true; });
  values_.flag("--mute", "no sound", [&] { options_.mute = true; });
  values_.path(
      "--settings", "the settings file (~/.config/gpuwars/settings.toml)", "FILE",
      [&](std::string v) { options_.settingsPath = v; }, kDiagnostics);
}

void VerbOptions::addReplay() {
  values_.files("FILE", "the replay to watch", 1, [&](std::string v) { options_.files.emplace_back(v); });
  values_.number("--speed", "times real time (1)", 0.1, 16, [&](double v) { options_.speed = v; });
  values_.integer("--from", "the tick to start watching at", 0, kMaxTicks,
                  [&](uint64_t v) { options_.fromTick = uint32_t(v); });
  values_.flag("--quit-at-end", "leave after the last tick", [&] { options_.quitAtEnd = true; });
}

void VerbOptions::addRender() {
  values_.files("FILE", "the replay to make pictures of", 1, [&](std::string v) { options_.files.emplace_back(v); });
  values_.path("--out", "a folder for one picture a frame, FILE.png for one tick's, or FILE.mp4 for a film", "OUT",
               [&](std::string v) { options_.outPath = v; });
  values_.integer("--from", "the first tick to draw (1)", 1, kMaxTicks,
                  [&](uint64_t v) { options_.fromTick = uint32_t(v); });
  values_.integer("--to", "the last tick to draw (the replay's last); of FILE.png the only one", 1, kMaxTicks,
                  [&](uint64_t v) { options_.toTick = uint32_t(v); });
  addSize();
  values_.choice("--fps", kFrameRates, "pictures per second of game time", "60",
                 [&](uint32_t v) { options_.framesPerSecond = v; });
  values_.choice("--hud", kHud, "score, budget and counts", "on", [&](uint32_t v) { options_.hud = v != 0; });
}

void VerbOptions::addVerify() {
  values_.files("FILE", "the replays to run again", SIZE_MAX, [&](std::string v) { options_.files.emplace_back(v); });
  values_.integer("-j,--jobs", "how many replays at the same time (1)", 1, 256,
                  [&](uint64_t v) { options_.jobs = uint32_t(v); });
  values_.path("--json", "write the results to OUT ('-': stdout)", "OUT",
               [&](std::string v) { options_.jsonPath = v; });
  values_.path("--hashes", "write one line a tick to OUT ('-': stdout)", "OUT",
               [&](std::string v) { options_.hashesPath = v; });
  addDesync();
}

void VerbOptions::addDesync() {
  values_.flag("--heavy", "take and restore a snapshot after every tick", [&] { options_.heavy = true; });
  values_.flag("--shuffle", "the cpu device visits items in shuffled order, as --order shuffled",
               [&] { options_.order = VisitOrder::shuffled; });
  values_.choice("--against", kAgainst, "play beside another device, and place a difference", "nothing",
                 [&](uint32_t v) { options_.against = DeviceOption(v); });
  values_.path("--reference", "play beside another build of gpuwars, and place a difference", "PROGRAM",
               [&](std::string v) { options_.reference = v; });
  values_.text("--reference-options", "options of the reference, as '--threads 1'", "TEXT",
               [&](std::string v) { options_.referenceOptions = v; });
  values_.path("--junit", "write the results to OUT as JUnit's XML", "OUT",
               [&](std::string v) { options_.junitPath = v; });
}

void VerbOptions::addProbe() {
  values_.files("FILE", "the replay to play", 1, [&](std::string v) { options_.files.emplace_back(v); });
}

void VerbOptions::addTrim() {
  values_.files("FILE", "the replay to run again", 1, [&](std::string v) { options_.files.emplace_back(v); });
  values_.path("--out", "write the new replay to OUT, which may be FILE itself", "OUT",
               [&](std::string v) { options_.outPath = v; });
  values_.integer("--to", "the last tick to keep (all there are)", 1, kMaxTicks,
                  [&](uint64_t v) { options_.toTick = uint32_t(v); });
}

void VerbOptions::addDiff() {
  values_.files("FILE", "the two replays to compare", 2, [&](std::string v) { options_.files.emplace_back(v); });
  values_.pathOrStdout("--json", "write what differs as JSON to OUT, or to stdout", "OUT",
                       [&](std::string v) { options_.jsonPath = v; });
}

void VerbOptions::addDevices() {
  values_.pathOrStdout("--json", "write the list as JSON to OUT, or to stdout", "OUT",
                       [&](std::string v) { options_.jsonPath = v; });
}

void VerbOptions::addProfile() {
  values_.choice("--scene", kScenes, "what is played", "five-minutes", [&](uint32_t v) {
    options_.scene = profile::SceneKind(v);
    options_.sceneAsked = true;
  });
  values_.path("--replay", "play this replay instead of a scene", "FILE",
               [&](std::string v) { options_.replayPath = v; });
  values_.path("--out", "the folder of the report, made where there is none", "DIR",
               [&](std::string v) { options_.outPath = v; });
  values_.text("--enemies", "how many live enemies fit (8192); several with commas are measured one by one", "N,N,...",
               [&](std::string v) { options_.enemiesList = enemiesIn(v); });
  values_.text("--compare", "contenders, with commas: ngrid, grid, grid-hashed, brute, thesis (the broad phase)",
               "A,B,...", [&](std::string v) { options_.compare = v; });
  values_.integer("--runs", "of each contender, in turn (10)", 1, 1000,
                  [&](uint64_t v) { options_.runs = uint32_t(v); });
  values_.integer("--ticks", "length of a run (all of the scene)", kLeastProfiledTicks, kMaxTicks,
                  [&](uint64_t v) { options_.ticks = uint32_t(v); });
  values_.integer("--seconds", "the same in seconds of game time", 1, kMaxTicks / kTicksPerSecond,
                  [&](uint64_t v) { options_.seconds = uint32_t(v); });
  values_.flag("--headless", "draw without a window", [&] { options_.headless = true; });
  values_.flag("--no-draw", "the simulation alone", [&] { options_.drawNothing = true; });
  values_.flag("--paced", "ticks when they are due, as in play; else one with every frame",
               [&] { options_.paced = true; });
  values_.choice("--view", kLooks, "what is drawn: as a player sees it, or the whole world", "player",
                 [&](uint32_t v) { options_.wholeWorld = v != 0; });
  values_.choice("--effects", kEffects, "particles, flashes, bending, shake", "on",
                 [&](uint32_t v) { options_.effects = v != 0; });
  values_.choice("--glow", kGlows, "how far light reaches outside a shape", "low",
                 [&](uint32_t v) { options_.glow = float(v) / 2; });
  values_.path("--trace", "write trace events for Perfetto or Chrome to FILE", "FILE",
               [&](std::string v) { options_.tracePath = v; });
  values_.path("--baseline", "compare with an earlier report.json; exit 1 when slower beyond the noise", "FILE",
               [&](std::string v) { options_.baselinePath = v; });
  addSize();
}

const char* nameOf(BroadPhase broadPhase) {
  return wordFor(kBroadPhases, uint32_t(broadPhase));
}
const char* nameOf(Gather gather) {
  return wordFor(kGathers, uint32_t(gather));
}
const char* nameOf(Sort sort) {
  return wordFor(kSorts, uint32_t(sort));
}

}  // namespace gw
