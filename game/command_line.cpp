#include "game/command_line.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <stdexcept>

#include "game/command_line_checks.h"
#include "game/command_line_values.h"
#include "game/replay/format.h"

namespace gw {
namespace {

struct VerbName {
  std::string_view name;
  Verb verb;
  const char* summary;
};
constexpr VerbName kVerbs[] = {
    {"play", Verb::play, "Play; what happens with no verb at all."},
    {"replay", Verb::replay, "Watch a replay."},
    {"verify", Verb::verify, "Run replays again and compare every tick."},
    {"render", Verb::render, "Make a film or pictures of a replay; needs no display."},
    {"trim", Verb::trim, "Run a replay again up to a tick and write what was run, whole and in today's format."},
    {"diff", Verb::diff, "Say where two replays part."},
    {"devices", Verb::devices, "Say which devices there are and which one 'auto' takes."},
    {"probe", Verb::probe, "Play a run for 'gpuwars verify --reference' of another build."},
};
constexpr std::string_view kLaterVerbs[] = {"profile"};

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

std::string mainHelp() {
  std::string text = "GpuWars: a twin-stick shooter whose whole simulation runs as GPU kernels.\n\n";
  text += "Usage: gpuwars [VERB] [OPTIONS]\n\nVerbs:\n";
  for (const VerbName& verb : kVerbs) text += fmt::format("  {:<9}{}\n", verb.name, verb.summary);
  text += "\n'gpuwars VERB --help' lists a verb's options; they mean the same under every verb.\n";
  text += "Exit codes: 0 fine, 1 failed run (diff: they differ), 2 bad usage, 3 bad file, 4 desync.\n";
  return text;
}

// The options of one verb, bound to `options`. Values are taken as text and read by command_line_values,
// so that every refusal is one sentence of ours.
class VerbParser {
 public:
  VerbParser(const VerbName& verb, Options& options)
      : verb_(verb),
        options_(options),
        app_(verb.summary, fmt::format("gpuwars {}", verb.name)),
        values_(app_, std::string(verb.name)) {
    app_.set_version_flag("--version", versionText());
    app_.allow_extras();  // so that checkExtras() can say where they belong
    options_.verb = verb.verb;
    if (verb.verb == Verb::play) addGame();
    if (verb.verb != Verb::devices && verb.verb != Verb::diff) addComputing();
    if (verb.verb == Verb::play || verb.verb == Verb::replay) addWindow();
    if (verb.verb == Verb::render) addRender();
    if (verb.verb == Verb::replay) addReplay();
    if (verb.verb == Verb::verify) addVerify();
    if (verb.verb == Verb::trim) addTrim();
    if (verb.verb == Verb::diff) addDiff();
    if (verb.verb == Verb::devices) addDevices();
    if (verb.verb == Verb::probe) addProbe();
  }

  // Throws UsageError or CLI::CallForHelp and the like.
  void parse(std::vector<std::string> arguments) {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
    try {
      app_.parse(arguments);
    } catch (const CLI::Success&) {
      throw;
    } catch (const CLI::ParseError& error) {
      values_.explain(error);
    }
    checkExtras();
    values_.read();
    if (options_.thesis) takeThesis(options_);
    if (takesFiles() && options_.files.empty()) {
      throw UsageError(fmt::format("'gpuwars {}' needs a replay; name the file", verb_.name));
    }
    if (verb_.verb == Verb::diff && options_.files.size() < 2) {
      throw UsageError("'gpuwars diff' compares two replays; name both files");
    }
    if (verb_.verb == Verb::trim && options_.outPath.empty()) {
      throw UsageError("'gpuwars trim' needs to know what to write; add '--out FILE'");
    }
    checkContradictions(options_);
  }

  std::string help() const { return app_.help(); }

  bool knows(const std::string& option) const { return app_.get_option_no_throw(option) != nullptr; }

  static std::string versionText() {
    return fmt::format("gpuwars {} (simulation {}, replay format {}.{})", GW_VERSION, kSimulationVersion, kReplayMajor,
                       kReplayMinor);
  }

 private:
  void addGame() {
    values_.choice("--mode", kModes, "the game", "arcade", [&](uint32_t v) { options_.mode = Mode(v); });
    values_.integer("--seed", "seed of the game; by default 1 when headless, else a new one each time", 0, UINT64_MAX,
                    [&](uint64_t v) { options_.seed = v; });
    values_.integer("--enemies", "how many live enemies fit (8192)", 1, kMaxEnemies,
                    [&](uint64_t v) { options_.enemies = uint32_t(v); });
    values_.choice("--autopilot", kAutopilots, "who plays instead of you", "nobody",
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

  void addComputing() {
    values_.choice("--device", kDevices, "what computes", "auto",
                   [&](uint32_t v) { options_.device = DeviceOption(v); });
    values_.integer("--threads", "worker threads of the cpu device (0: what the machine has)", 0, 256,
                    [&](uint64_t v) { options_.threads = uint32_t(v); });
    values_.choice("--broad-phase", kBroadPhases, "how neighbours are found; cannot change the game", "ngrid",
                   [&](uint32_t v) { options_.broadPhase = BroadPhase(v); });
    const bool play = verb_.verb == Verb::play;
    values_.choice("--gather", kGathers, "how the NGrid is asked; adaptive and fixed miss some, in a game of their own",
                   play ? "exact" : "the replay's", [&](uint32_t v) { options_.gather = Gather(v); });
    values_.choice("--sort", kSorts, "how the NGrid is kept in order",
                   play ? "frozen, or bitonic where a gather is inexact" : "the replay's where it matters, else frozen",
                   [&](uint32_t v) { options_.sort = Sort(v); });
    values_.flag("--thesis", "the thesis's own NGrid: --gather adaptive --sort bitonic",
                 [&] { options_.thesis = true; });
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

  void addSize() {
    values_.integer("--width", "of the window or picture, in pixels (1280)", 320, 7680,
                    [&](uint64_t v) { options_.width_px = uint32_t(v); });
    values_.integer("--height", "of the window or picture, in pixels (720)", 200, 4320,
                    [&](uint64_t v) { options_.height_px = uint32_t(v); });
  }

  void addWindow() {
    addSize();
    values_.flag("--fullscreen", "fill the screen", [&] { options_.fullscreen = true; });
    values_.flag("--mute", "no sound", [&] { options_.mute = true; });
    values_.path(
        "--settings", "the settings file (~/.config/gpuwars/settings.toml)", "FILE",
        [&](std::string v) { options_.settingsPath = v; }, kDiagnostics);
  }

  void addReplay() {
    values_.files("FILE", "the replay to watch", 1, [&](std::string v) { options_.files.emplace_back(v); });
    values_.number("--speed", "times real time (1)", 0.1, 16, [&](double v) { options_.speed = v; });
    values_.integer("--from", "the tick to start watching at", 0, kMaxTicks,
                    [&](uint64_t v) { options_.fromTick = uint32_t(v); });
  }

  void addRender() {
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

  void addVerify() {
    values_.files("FILE", "the replays to run again", SIZE_MAX, [&](std::string v) { options_.files.emplace_back(v); });
    values_.integer("-j,--jobs", "how many replays at the same time (1)", 1, 256,
                    [&](uint64_t v) { options_.jobs = uint32_t(v); });
    values_.path("--json", "write the results to OUT ('-': stdout)", "OUT",
                 [&](std::string v) { options_.jsonPath = v; });
    values_.path("--hashes", "write one line a tick to OUT ('-': stdout)", "OUT",
                 [&](std::string v) { options_.hashesPath = v; });
    addDesync();
  }

  void addDesync() {
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

  void addProbe() {
    values_.files("FILE", "the replay to play", 1, [&](std::string v) { options_.files.emplace_back(v); });
  }

  void addTrim() {
    values_.files("FILE", "the replay to run again", 1, [&](std::string v) { options_.files.emplace_back(v); });
    values_.path("--out", "write the new replay to OUT, which may be FILE itself", "OUT",
                 [&](std::string v) { options_.outPath = v; });
    values_.integer("--to", "the last tick to keep (all there are)", 1, kMaxTicks,
                    [&](uint64_t v) { options_.toTick = uint32_t(v); });
  }

  void addDiff() {
    values_.files("FILE", "the two replays to compare", 2, [&](std::string v) { options_.files.emplace_back(v); });
    values_.pathOrStdout("--json", "write what differs as JSON to OUT, or to stdout", "OUT",
                         [&](std::string v) { options_.jsonPath = v; });
  }

  void addDevices() {
    values_.pathOrStdout("--json", "write the list as JSON to OUT, or to stdout", "OUT",
                         [&](std::string v) { options_.jsonPath = v; });
  }

  bool takesFiles() const { return verb_.verb != Verb::play && verb_.verb != Verb::devices; }

  void checkExtras() const {
    std::vector<std::string> extras = app_.remaining();
    std::erase(extras, "--");
    if (extras.empty()) return;
    const std::string& extra = extras.front();
    if (!extra.starts_with("-")) {
      throw UsageError(fmt::format("'{}' is not understood; 'gpuwars {}' takes options only", extra, verb_.name));
    }
    const std::string option = extra.substr(0, extra.find('='));
    for (const VerbName& other : kVerbs) {
      Options unused;
      if (VerbParser(other, unused).knows(option)) {
        throw UsageError(fmt::format("'{}' belongs to 'gpuwars {}', not to 'gpuwars {}'; leave it out", option,
                                     other.name, verb_.name));
      }
    }
    throw UsageError(fmt::format("'{}' is not an option; see 'gpuwars {} --help'", option, verb_.name));
  }

  static constexpr const char* kDiagnostics = "Diagnostics";

  VerbName verb_;
  Options& options_;
  CLI::App app_;
  CommandLineValues values_;
};

const VerbName* findVerb(std::string_view name) {
  const auto* found =
      std::find_if(std::begin(kVerbs), std::end(kVerbs), [&](const VerbName& v) { return v.name == name; });
  return found == std::end(kVerbs) ? nullptr : found;
}

// The verb that the arguments begin with; takes it off them.
const VerbName& takeVerb(std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with("-")) return kVerbs[0];
  const std::string name = arguments.front();
  if (std::find(std::begin(kLaterVerbs), std::end(kLaterVerbs), name) != std::end(kLaterVerbs)) {
    throw UsageError(notYet("gpuwars " + name, "see 'gpuwars --help' for what is"));
  }
  const VerbName* verb = findVerb(name);
  if (!verb) {
    throw UsageError(
        fmt::format("'{}' is not a verb; choose play, replay, verify, render, trim, diff or devices (to watch a file: "
                    "'gpuwars replay FILE')",
                    name));
  }
  arguments.erase(arguments.begin());
  return *verb;
}

// As one line, with quotes where a shell needs them.
std::string joined(const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) {
    const bool plain = !argument.empty() && argument.find_first_of(" \t\n'\"\\$&|;<>()*?") == std::string::npos;
    if (!text.empty()) text += ' ';
    text += plain ? argument : fmt::format("'{}'", argument);
  }
  return text;
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

const char* nameOf(BroadPhase broadPhase) {
  return wordFor(kBroadPhases, uint32_t(broadPhase));
}
const char* nameOf(Gather gather) {
  return wordFor(kGathers, uint32_t(gather));
}
const char* nameOf(Sort sort) {
  return wordFor(kSorts, uint32_t(sort));
}

ParsedCommandLine parseCommandLine(const std::vector<std::string>& arguments) {
  ParsedCommandLine result;
  if (arguments.size() == 1 && (arguments[0] == "--help" || arguments[0] == "-h")) {
    result.output = mainHelp();
    return result;
  }
  try {
    std::vector<std::string> rest = arguments;
    VerbParser parser(takeVerb(rest), result.options);
    try {
      parser.parse(rest);
      result.options.text = joined(arguments);
      result.run = true;
    } catch (const CLI::CallForVersion&) {
      result.output = VerbParser::versionText() + "\n";
    } catch (const CLI::Success&) {
      result.output = parser.help();
    }
  } catch (const UsageError& error) {
    result.code = ExitCode::badUsage;
    result.error = error.what();
    const auto isControl = [](char c) { return uint8_t(c) < 0x20 || c == 0x7f; };
    std::replace_if(result.error.begin(), result.error.end(), isControl, '?');  // one line, whatever it quotes
  }
  return result;
}

}  // namespace gw
