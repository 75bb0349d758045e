#include "game/cli/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace gw {
namespace {

std::string head(const std::string& name, const PageHead& page) {
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(), [](char c) { return char(std::toupper(uint8_t(c))); });
  return fmt::format(".TH {} 6 \"{}\" \"gpuwars {}\" Games\n", roffText(title), page.date, page.version);
}

// "Watch a replay." as the line that apropos shows: without capital and full stop.
std::string asClause(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  if (!sentence.empty()) sentence[0] = char(std::tolower(uint8_t(sentence[0])));
  return sentence;
}

std::string bold(std::string_view text) {
  return fmt::format("\\fB{}\\fR", roffText(text));
}
std::string italic(std::string_view text) {
  return fmt::format("\\fI{}\\fR", roffText(text));
}

// Each part of a list, in `style`, with `between` between them.
std::string joined(std::string_view list, char separator, std::string (*style)(std::string_view),
                   std::string_view between) {
  std::string text;
  for (size_t begin = 0; begin <= list.size();) {
    const size_t end = std::min(list.find(separator, begin), list.size());
    if (begin) text += between;
    text += style(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return text;
}

std::string value(const OptionText& option) {
  if (option.value == OptionText::Value::none) return {};
  const std::string text =
      option.value == OptionText::Value::word ? joined(option.placeholder, '|', bold, "|") : italic(option.placeholder);
  return option.valueOptional ? fmt::format(" [{}]", text) : " " + text;
}

std::string entry(const OptionText& option) {
  const bool file = option.value == OptionText::Value::files;
  const std::string term = file ? italic(option.names) : joined(option.names, ',', bold, ", ") + value(option);
  return fmt::format(".TP\n{}\n{}\n", term, roffText(option.help));
}

// Those of a group, in the order of the table.
std::string entries(const std::vector<OptionText>& options, std::string_view group) {
  std::string text;
  for (const OptionText& option : options) {
    if (option.group == group) text += entry(option);
  }
  return text;
}

std::string synopsis(const VerbText& verb) {
  std::string text = fmt::format(".B gpuwars {}\n[\\fIoptions\\fR]", roffText(verb.name));
  for (const OptionText& option : verb.options) {
    if (option.value != OptionText::Value::files) continue;
    const bool any = option.most > 2;
    for (size_t i = 0; i < (any ? 1 : option.most); ++i) text += " " + italic(option.names);
    if (any) text += " ...";
  }
  return text + "\n";
}

std::string exitStatus() {
  std::string text = ".SH EXIT STATUS\n";
  for (const ExitText& exit : kExitTexts) text += fmt::format(".TP\n.B {}\n{}\n", exit.code, roffText(exit.meaning));
  return text;
}

}  // namespace

std::string roffText(std::string_view text) {
  // A line that begins with one of these is a request.
  std::string escaped = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    switch (c) {
      case '\\':
        escaped += "\\e";
        break;
      case '-':  // of an option, not a hyphen
        escaped += "\\-";
        break;
      case '\'':
        escaped += "\\(aq";
        break;
      case '~':
        escaped += "\\(ti";
        break;
      case '"':
        escaped += "\\(dq";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string mainPage(const std::vector<VerbText>& verbs, const PageHead& page) {
  std::string text = head("gpuwars", page);
  text +=
      ".SH NAME\ngpuwars \\- twin\\-stick shooter whose whole simulation runs as GPU kernels\n"
      ".SH SYNOPSIS\n.B gpuwars\n[\\fIverb\\fR] [\\fIoptions\\fR]\n"
      ".SH DESCRIPTION\n"
      "You are a GPUship inside the computer universe and process (shoot) what a GPU processes: thousands of enemies,\n"
      "each of which thinks, moves and collides sixty times a second.\n"
      "Without an NVIDIA GPU the same kernels run on the processor, with the same results, bit for bit.\n"
      ".PP\n"
      "Games can be recorded; a replay can be watched, made into a film, and verified tick by tick.\n"
      "Options mean the same under every verb; each verb has a page of its own.\n"
      ".SH VERBS\n";
  for (const VerbText& verb : verbs) {
    text += fmt::format(".TP\n{}\n{}\n", bold(verb.name), roffText(verb.summary));
  }
  text += ".SH OPTIONS\n" + entries(kHelpOptions, "Options");
  text +=
      ".SH FILES\n.TP\n.I \\(ti/.config/gpuwars/settings.toml\n"
      "The settings, written by the settings screen; " +
      bold("--settings") +
      " names another file.\n"
      ".SH ENVIRONMENT\n.TP\n.B XDG_CONFIG_HOME\nThe folder of settings in place of " +
      italic("~/.config") +
      ".\n"
      ".TP\n.B CUDA_VISIBLE_DEVICES\nHides NVIDIA GPUs from CUDA programs.\n";
  text += exitStatus() + ".SH SEE ALSO\n";
  for (const VerbText& verb : verbs) {
    text += fmt::format(".BR gpuwars\\-{} (6){}\n", roffText(verb.name), &verb == &verbs.back() ? "" : ",");
  }
  return text;
}

std::string verbPage(const VerbText& verb, const PageHead& page) {
  const std::string name = "gpuwars-" + verb.name;
  std::string text = head(name, page);
  text += fmt::format(".SH NAME\n{} \\- {}\n", roffText(name), roffText(asClause(verb.summary)));
  text += ".SH SYNOPSIS\n" + synopsis(verb);
  text += fmt::format(".SH DESCRIPTION\n{}\n.SH OPTIONS\n", roffText(verb.summary));
  text += entries(verb.options, "Files") + entries(verb.options, "Options") + entries(kHelpOptions, "Options");
  // Groups of their own, each once.
  std::vector<std::string> seen{"Files", "Options"};
  for (const OptionText& option : verb.options) {
    if (std::find(seen.begin(), seen.end(), option.group) != seen.end()) continue;
    seen.push_back(option.group);
    text += fmt::format(".SS {}\n", roffText(option.group)) + entries(verb.options, option.group);
  }
  return text + exitStatus() + ".SH SEE ALSO\n.BR gpuwars (6)\n";
}

}  // namespace gw
