// Man pages in roff, made from the tables of the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/cli/command_text.h"

namespace gw {

// What the first line of a page names beside the page.
struct PageHead {
  std::string version;  // "0.1.0"
  std::string date;     // "2026-11-30"
};

// Text as roff shows it unchanged, wherever it stands in a line.
std::string roffText(std::string_view text);

// The page of the program: what it is, the verbs, files, environment and exit codes.
std::string mainPage(const ProgramText& program, const std::vector<VerbText>& verbs, const PageHead& head);
// The page of one verb: gpuwars-diff(6).
std::string verbPage(const ProgramText& program, const VerbText& verb, const PageHead& head);

}  // namespace gw
