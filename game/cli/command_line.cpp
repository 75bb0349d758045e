#include "game/cli/command_line.h"

#include <utility>

#include "host/cli/verb_parser.h"

namespace gw {
namespace {

// One of each row of the table, with the usual values.
template <size_t... kRow>
std::vector<VerbOptions> allVerbs(std::index_sequence<kRow...>) {
  return {VerbOptions(std::in_place_index<kRow>)...};
}

std::vector<VerbOptions> allVerbs() {
  return allVerbs(std::make_index_sequence<std::variant_size_v<VerbOptions>>());
}

// For the parser, which stores what it reads in `all`.
std::vector<Verb> verbsInto(std::vector<VerbOptions>& all) {
  std::vector<Verb> verbs;
  const auto verbOf = [](auto& own) {
    return Verb{own.kName, own.kSummary, [&own](OptionSet& options) { own.declare(options); }, [&own] { own.check(); }};
  };
  for (VerbOptions& options : all) verbs.push_back(std::visit(verbOf, options));
  return verbs;
}

}  // namespace

ParsedCommandLine parseCommandLine(const std::vector<std::string>& arguments) {
  std::vector<VerbOptions> all = allVerbs();
  ParsedVerb parsed = parseVerb(programText(), verbsInto(all), arguments);
  ParsedCommandLine result{parsed.run, std::move(all[parsed.verb]), parsed.code, std::move(parsed.output),
                           std::move(parsed.error)};
  if (auto* play = std::get_if<PlayOptions>(&result.options)) play->text = joined(arguments);
  return result;
}

std::vector<VerbText> describeCommandLine() {
  std::vector<VerbOptions> all = allVerbs();
  return describe(programText(), verbsInto(all));
}

}  // namespace gw
