// Another program that makes a file for this one: what to tell the user when it does not.
#pragma once

#include <filesystem>
#include <string>

namespace gw {

struct ExternalTool {
  const char* program;
  const char* package;    // of Debian and Ubuntu
  const char* otherwise;  // what the user can do without it: "give a folder as --out to get the pictures"
};

// The cause in what a program said: of its lines the first that names an error of the system, else its first; without
// what only its authors can read. The last line is often a consequence. Empty when it said nothing.
std::string firstCause(const std::string& said);

// Each is one sentence. It failed with `code` (0: it ended before it had read all), and `said` something:
std::string couldNotMake(const ExternalTool& maker, const std::filesystem::path& path, const std::string& said,
                         int code);
// It ended well, and what should be at `path` is empty or not there:
std::string madeNothing(const ExternalTool& maker, const std::filesystem::path& path);
// It ended well, and what it wrote is not `what` ("a film"), or only a part of it:
std::string madeSomethingElse(const ExternalTool& maker, const std::filesystem::path& path, const char* what);

}  // namespace gw
