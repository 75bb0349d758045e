// gw_write_manual FOLDER VERSION DATE: writes the man pages into FOLDER/man6 and the completion for bash into
// FOLDER/completions, for packages. A program of the build, not installed.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "game/cli/command_line.h"
#include "host/cli/bash_completion.h"
#include "host/cli/man_page.h"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + " cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: gw_write_manual FOLDER VERSION DATE\n", stderr);
    return 2;
  }
  try {
    const fs::path folder = argv[1];
    const gw::PageHead head{argv[2], argv[3]};
    const gw::ProgramText& program = gw::programText();
    const std::vector<gw::VerbText> verbs = gw::describeCommandLine();
    write(folder / "man6" / (program.name + ".6"), gw::mainPage(program, verbs, head));
    for (const gw::VerbText& verb : verbs) {
      write(folder / "man6" / (program.name + "-" + verb.name + ".6"), gw::verbPage(program, verb, head));
    }
    write(folder / "completions" / program.name, gw::bashCompletion(program, verbs));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gw_write_manual: %s\n", error.what());
    return 1;
  }
  return 0;
}
