#include "host/cli/verb_parser.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw {
namespace {

std::string programHelp(const ProgramText& program, std::span<const Verb> verbs) {
  std::string text =
      fmt::format("{}: {}.\n\nUsage: {} [VERB] [OPTIONS]\n\nVerbs:\n", program.title, program.summary, program.name);
  for (const Verb& verb : verbs) text += fmt::format("  {:<9}{}\n", verb.name, verb.summary);
  text +=
      fmt::format("\n'{} VERB --help' lists a verb's options; they mean the same under every verb.\n", program.name);
  std::string exits;
  for (const NamedText& exit : program.exitCodes) {
    const char* before = exits.empty() ? "Exit codes: " : exit.name.size() == 1 ? ", " : ";\n";
    exits += fmt::format("{}{} {}", before, exit.name, exit.text);
  }
  return text + exits + ".\n";
}

OptionSet optionsOf(const ProgramText& program, const Verb& verb) {
  return OptionSet(program.name + " " + verb.name, program.version);
}

// The index of the verb that the arguments begin with; removes it from them.
size_t takeVerb(const ProgramText& program, std::span<const Verb> verbs, std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with("-")) return 0;
  const std::string name = arguments.front();
  const auto found = std::find_if(verbs.begin(), verbs.end(), [&](const Verb& verb) { return verb.name == name; });
  if (found == verbs.end()) {
    std::string names;
    for (const Verb& verb : verbs) {
      names += (names.empty() ? "" : &verb == &verbs.back() ? " or " : ", ") + verb.name;
    }
    throw UsageError(fmt::format("'{}' is not a verb; choose {} ({})", name, names, program.verbHint));
  }
  arguments.erase(arguments.begin());
  return size_t(found - verbs.begin());
}

// Refuses what no option took, and names the verb that would have taken it.
void refuseExtras(const ProgramText& program, std::span<const Verb> verbs, const Verb& verb,
                  std::vector<std::string> extras) {
  std::erase(extras, "--");
  if (extras.empty()) return;
  const std::string& extra = extras.front();
  if (!extra.starts_with("-")) {
    throw UsageError(fmt::format("'{}' is not understood; '{} {}' takes options only", extra, program.name, verb.name));
  }
  const std::string option = extra.substr(0, extra.find('='));
  for (const Verb& other : verbs) {
    OptionSet options = optionsOf(program, other);
    other.declare(options);
    if (!options.knows(option)) continue;
    throw UsageError(fmt::format("'{}' belongs to '{} {}', not to '{} {}'; leave it out", option, program.name,
                                 other.name, program.name, verb.name));
  }
  throw UsageError(fmt::format("'{}' is not an option; see '{} {} --help'", option, program.name, verb.name));
}

void parseInto(ParsedVerb& result, const ProgramText& program, std::span<const Verb> verbs,
               std::vector<std::string> arguments) {
  result.verb = takeVerb(program, verbs, arguments);
  const Verb& verb = verbs[result.verb];
  OptionSet options = optionsOf(program, verb);
  verb.declare(options);
  switch (options.parse(std::move(arguments))) {
    case OptionSet::Request::help:
      result.output = options.help(verb.summary);
      return;
    case OptionSet::Request::version:
      result.output = program.version + "\n";
      return;
    case OptionSet::Request::run:
      break;
  }
  refuseExtras(program, verbs, verb, options.remaining());
  options.read();
  verb.check();
  result.run = true;
}

}  // namespace

ParsedVerb parseVerb(const ProgramText& program, std::span<const Verb> verbs, std::vector<std::string> arguments) {
  ParsedVerb result;
  if (arguments.size() == 1 && (arguments[0] == "--help" || arguments[0] == "-h")) {
    result.output = programHelp(program, verbs);
    return result;
  }
  try {
    parseInto(result, program, verbs, std::move(arguments));
  } catch (const UsageError& error) {
    result.code = error.code;
    result.error = error.what();
    const auto isControl = [](char c) { return uint8_t(c) < 0x20 || c == 0x7f; };
    std::replace_if(result.error.begin(), result.error.end(), isControl, '?');  // one line, whatever it quotes
  }
  return result;
}

std::vector<VerbText> describe(const ProgramText& program, std::span<const Verb> verbs) {
  std::vector<VerbText> texts;
  for (const Verb& verb : verbs) {
    OptionSet options = optionsOf(program, verb);
    verb.declare(options);
    texts.push_back({verb.name, verb.summary, options.described()});
  }
  return texts;
}

std::string joined(const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) {
    const bool plain = !argument.empty() && argument.find_first_of(" \t\n'\"\\$&|;<>()*?") == std::string::npos;
    if (!text.empty()) text += ' ';
    text += plain ? argument : fmt::format("'{}'", argument);
  }
  return text;
}

}  // namespace gw
