#include "host/cli/bash_completion.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw {
namespace {

// @ stands for the name of the program, FILES for the pattern of its files.
constexpr const char* kHead = R"(# Completion of @ in bash; written by its build from the table of its options.
_@() {
  local current="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD-1]}" verb="${COMP_WORDS[1]:-}"
  local options="" words="" files=""
  # bash splits --option=value in three.
  if [[ "$current" == "=" ]]; then
    current=""
  elif [[ "$before" == "=" ]]; then
    before="${COMP_WORDS[COMP_CWORD-2]}"
  fi
)";

constexpr const char* kTail = R"(  if [[ -n "$words" ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  elif [[ -n "$files" ]]; then
    compopt -o filenames 2>/dev/null
    case "$files" in
      any) mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
      folder) mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
      input) mapfile -t COMPREPLY < <(compgen -d -- "$current"; compgen -f -X '!FILES' -- "$current") ;;
      none) COMPREPLY=() ;;
    esac
  fi
}
complete -F _@ @
)";

std::string replaced(std::string text, std::string_view old, std::string_view by) {
  for (size_t at = text.find(old); at != text.npos; at = text.find(old, at + by.size())) {
    text.replace(at, old.size(), by);
  }
  return text;
}

std::string spaced(std::string words) {
  std::replace(words.begin(), words.end(), '|', ' ');
  std::replace(words.begin(), words.end(), ',', ' ');
  return words;
}

// The pattern of a case: "-j|--jobs".
std::string pattern(std::string names) {
  std::replace(names.begin(), names.end(), ',', '|');
  return names;
}

// What may follow an option, as an assignment; empty: it takes no value.
std::string following(const OptionText& option) {
  switch (option.value) {
    case OptionText::Value::none:
    case OptionText::Value::files:
      return {};
    case OptionText::Value::word:
      return fmt::format("words=\"{}\"", spaced(option.placeholder));
    case OptionText::Value::path:
      return option.placeholder == "DIR" ? "files=folder" : "files=any";
    case OptionText::Value::number:
    case OptionText::Value::text:
      return "files=none";
  }
  return {};
}

std::string verbCase(const VerbText& verb) {
  std::string options, values;
  bool takesFiles = false;
  for (const OptionText& option : verb.options) {
    if (option.value == OptionText::Value::files) {
      takesFiles = true;
      continue;
    }
    options += spaced(option.names) + " ";
    const std::string next = following(option);
    if (!next.empty()) values += fmt::format("        {}) {} ;;\n", pattern(option.names), next);
  }
  for (const OptionText& option : kHelpOptions) options += spaced(option.names) + " ";
  options.pop_back();
  return fmt::format(
      "    {})\n      options=\"{}\"\n      case \"$before\" in\n{}        *) {} ;;\n      esac\n      ;;\n", verb.name,
      options, values, takesFiles ? "files=input" : "words=\"$options\"");
}

}  // namespace

std::string bashCompletion(const ProgramText& program, const std::vector<VerbText>& verbs) {
  std::string names, cases;
  for (const VerbText& verb : verbs) {
    names += (names.empty() ? "" : " ") + verb.name;
    cases += verbCase(verb);
  }
  std::string text = replaced(kHead, "@", program.name);
  text +=
      fmt::format("  case \" {} \" in\n    *\" $verb \"*) ;;\n    *) verb={} ;;\n  esac\n", names, verbs.front().name);
  text += "  case \"$verb\" in\n" + cases + "  esac\n";
  text += "  if [[ \"$current\" == -* ]]; then\n    words=\"$options\"\n";
  text += fmt::format("  elif ((COMP_CWORD == 1)); then\n    words=\"{} $options\"\n  fi\n", names);
  return text + replaced(replaced(kTail, "@", program.name), "FILES", program.filePattern);
}

}  // namespace gw
