#include "host/cli/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace gw {
namespace {

std::string head(const ProgramText& program, const std::string& name, const PageHead& page) {
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(), [](char c) { return char(std::toupper(uint8_t(c))); });
  return fmt::format(".TH {} 6 \"{}\" \"{} {}\" Games\n", roffText(title), page.date, roffText(program.name),
                     page.version);
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

std::string synopsis(const ProgramText& program, const VerbText& verb) {
  std::string text = fmt::format(".B {} {}\n[\\fIoptions\\fR]", roffText(program.name), roffText(verb.name));
  for (const OptionText& option : verb.options) {
    if (option.value != OptionText::Value::files) continue;
    const bool any = option.most > 2;
    for (size_t i = 0; i < (any ? 1 : option.most); ++i) text += " " + italic(option.names);
    if (any) text += " ...";
  }
  return text + "\n";
}

// One paragraph each, the name in `style`.
std::string definitions(const std::vector<NamedText>& texts, const char* style) {
  std::string text;
  for (const NamedText& each : texts) {
    text += fmt::format(".TP\n{} {}\n{}\n", style, roffText(each.name), roffText(each.text));
  }
  return text;
}

std::string exitStatus(const ProgramText& program) {
  return ".SH EXIT STATUS\n" + definitions(program.exitCodes, ".B");
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

std::string mainPage(const ProgramText& program, const std::vector<VerbText>& verbs, const PageHead& page) {
  const std::string name = roffText(program.name);
  std::string text = head(program, program.name, page);
  text += fmt::format(".SH NAME\n{} \\- {}\n", name, roffText(program.summary));
  text += fmt::format(".SH SYNOPSIS\n.B {}\n[\\fIverb\\fR] [\\fIoptions\\fR]\n.SH DESCRIPTION\n", name);
  for (const std::string& paragraph : program.paragraphs) {
    text += (&paragraph == &program.paragraphs.front() ? "" : ".PP\n") + roffText(paragraph) + "\n";
  }
  text += ".SH VERBS\n";
  for (const VerbText& verb : verbs) {
    text += fmt::format(".TP\n{}\n{}\n", bold(verb.name), roffText(verb.summary));
  }
  text += ".SH OPTIONS\n" + entries(kHelpOptions, kOptionsGroup);
  text += ".SH FILES\n" + definitions(program.files, ".I");
  text += ".SH ENVIRONMENT\n" + definitions(program.environment, ".B");
  text += exitStatus(program) + ".SH SEE ALSO\n";
  for (const VerbText& verb : verbs) {
    text += fmt::format(".BR {}\\-{} (6){}\n", name, roffText(verb.name), &verb == &verbs.back() ? "" : ",");
  }
  return text;
}

std::string verbPage(const ProgramText& program, const VerbText& verb, const PageHead& page) {
  const std::string name = program.name + "-" + verb.name;
  std::string text = head(program, name, page);
  text += fmt::format(".SH NAME\n{} \\- {}\n", roffText(name), roffText(asClause(verb.summary)));
  text += ".SH SYNOPSIS\n" + synopsis(program, verb);
  text += fmt::format(".SH DESCRIPTION\n{}\n.SH OPTIONS\n", roffText(verb.summary));
  text +=
      entries(verb.options, kFilesGroup) + entries(verb.options, kOptionsGroup) + entries(kHelpOptions, kOptionsGroup);
  // Groups of their own, each once.
  std::vector<std::string> seen{kFilesGroup, kOptionsGroup};
  for (const OptionText& option : verb.options) {
    if (std::find(seen.begin(), seen.end(), option.group) != seen.end()) continue;
    seen.push_back(option.group);
    text += fmt::format(".SS {}\n", roffText(option.group)) + entries(verb.options, option.group);
  }
  return text + exitStatus(program) + fmt::format(".SH SEE ALSO\n.BR {} (6)\n", roffText(program.name));
}

}  // namespace gw
