#include "game/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <optional>
#include <stdexcept>

#include "game/cli/command_line_checks.h"
#include "game/cli/command_line_options.h"
#include "game/cli/command_line_text.h"
#include "game/cli/command_line_values.h"
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
    {"profile", Verb::profile, "Measure frame rates and stage times; write a report with pictures."},
    {"trim", Verb::trim, "Run a replay again up to a tick and write what was run, whole and in today's format."},
    {"diff", Verb::diff, "Say where two replays part."},
    {"devices", Verb::devices, "Say which devices there are and which one 'auto' takes."},
    {"probe", Verb::probe, "Play a run for 'gpuwars verify --reference' of another build."},
};

std::string mainHelp() {
  std::string text = "GpuWars: a twin-stick shooter whose whole simulation runs as GPU kernels.\n\n";
  text += "Usage: gpuwars [VERB] [OPTIONS]\n\nVerbs:\n";
  for (const VerbName& verb : kVerbs) text += fmt::format("  {:<9}{}\n", verb.name, verb.summary);
  text += "\n'gpuwars VERB --help' lists a verb's options; they mean the same under every verb.\n";
  std::string exits;
  for (const ExitText& exit : kExitTexts) {
    const char* before = exits.empty() ? "Exit codes: " : exit.code.size() == 1 ? ", " : ";\n";
    exits += fmt::format("{}{} {}", before, exit.code, exit.meaning);
  }
  return text + exits + ".\n";
}

// The options of one verb, bound to `options`. Values are taken as text and read by command_line_values,
// so that every refusal is one sentence of ours.
class VerbParser {
 public:
  VerbParser(const VerbName& verb, Options& options)
      : verb_(verb), options_(options), values_(app_, std::string(verb.name)) {
    app_.set_version_flag("--version", versionText());
    app_.allow_extras();  // so that checkExtras() can say where they belong
    options_.verb = verb.verb;
    declared_.emplace(values_, options_);
  }

  // Throws UsageError or CLI::CallForHelp and the like.
  void parse(std::vector<std::string> arguments) {
    values_.parse(std::move(arguments));
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

  std::string help() const { return values_.help(verb_.summary); }
  VerbText described() const { return {std::string(verb_.name), verb_.summary, values_.described()}; }

  bool knows(const std::string& option) const { return app_.get_option_no_throw(option) != nullptr; }

  static std::string versionText() {
    return fmt::format("gpuwars {} (simulation {}, replay format {}.{})", GW_VERSION, kSimulationVersion, kReplayMajor,
                       kReplayMinor);
  }

 private:
  bool takesFiles() const {
    return verb_.verb != Verb::play && verb_.verb != Verb::devices && verb_.verb != Verb::profile;
  }

  void checkExtras() const {
    std::vector<std::string> extras = values_.remaining();
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

  VerbName verb_;
  Options& options_;
  CLI::App app_;
  CommandLineValues values_;
  std::optional<VerbOptions> declared_;
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
  const VerbName* verb = findVerb(name);
  if (!verb) {
    throw UsageError(fmt::format(
        "'{}' is not a verb; choose play, replay, verify, render, profile, trim, diff or devices (to watch a file: "
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

}  // namespace

const std::vector<OptionText> kHelpOptions = {
    {"-h,--help", "", "print this help and exit", CommandLineValues::kUsualGroup},
    {"--version", "", "print the version and exit", CommandLineValues::kUsualGroup},
};
const std::vector<ExitText> kExitTexts = {
    {std::to_string(int(ExitCode::fine)), "fine"},
    {std::to_string(int(ExitCode::failedRun)), "failed run (diff: they differ)"},
    {std::to_string(int(ExitCode::badUsage)), "bad usage"},
    {std::to_string(int(ExitCode::badFile)), "bad file"},
    {std::to_string(int(ExitCode::desync)), "desync"},
    {"128 + N", "signal N ended the run early (130: Ctrl-C), and what there was of it is whole"},
};

std::vector<VerbText> describeCommandLine() {
  std::vector<VerbText> verbs;
  for (const VerbName& verb : kVerbs) {
    Options unused;
    verbs.push_back(VerbParser(verb, unused).described());
  }
  return verbs;
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
