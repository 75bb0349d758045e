#include "tests/ptx_machine/runtime/allocation_origin.h"

#include <dlfcn.h>
#include <execinfo.h>

#include <array>
#include <cinttypes>
#include <cstdio>
#include <memory>
#include <regex>
#include <set>
#include <vector>

namespace gw::ptx {
namespace {

constexpr int kFrames = 24;

struct Origin {
  std::array<void*, kFrames> frames;
  int count = 0;
};

std::vector<Origin>& origins() {
  static auto* noted = new std::vector<Origin>;  // never destroyed: memory is allocated until the end
  return *noted;
}

// What stands between the source that wants memory and this file: the runtime, the driver, buffers, the library.
bool isOnTheWay(const std::string& function, const std::string& place) {
  for (const char* own : {"cuda", "gw::ptx::nameAllocation", "gw::stand_in::allocateDevice"}) {
    if (function.starts_with(own)) return true;
  }
  for (const char* folder : {"gpu/exec/", "/usr/", "??"}) {
    if (place.find(folder) != std::string::npos) return true;
  }
  return false;
}

// What addr2line says of the frames: function and place in turn, innermost first, those that were inlined too.
std::vector<std::string> linesOf(const Origin& origin) {
  Dl_info program{};
  if (dladdr(reinterpret_cast<void*>(&nameAllocation), &program) == 0) return {};
  std::string command = "addr2line -e /proc/self/exe -f -i -C";
  for (int f = 0; f < origin.count; ++f) {
    Dl_info from{};
    if (dladdr(origin.frames[size_t(f)], &from) == 0 || from.dli_fbase != program.dli_fbase) continue;
    char text[32];
    // One byte before the return address lies the call.
    const auto offset = uintptr_t(origin.frames[size_t(f)]) - uintptr_t(program.dli_fbase) - 1;
    std::snprintf(text, sizeof text, " 0x%" PRIxPTR, offset);
    command += text;
  }
  command.replace(command.find("/proc/self/exe"), 14, std::string("'") + program.dli_fname + "'");
  const std::unique_ptr<FILE, int (*)(FILE*)> output(popen((command + " 2>/dev/null").c_str(), "r"), pclose);
  std::vector<std::string> lines;
  char line[4096];
  while (output && std::fgets(line, sizeof line, output.get())) {
    lines.emplace_back(line);
    lines.back().resize(lines.back().find_last_not_of("\n") + 1);
  }
  return lines;
}

std::string originOf(size_t number) {
  const std::vector<std::string> lines = linesOf(origins()[number - 1]);
  for (size_t l = 0; l + 1 < lines.size(); l += 2) {
    if (!isOnTheWay(lines[l], lines[l + 1])) return "made by " + lines[l] + ", " + lines[l + 1];
  }
  return "made where this program has no line numbers, or addr2line is missing (package binutils)";
}

}  // namespace

std::string nameAllocation(size_t bytes) {
  Origin origin;
  origin.count = backtrace(origin.frames.data(), kFrames);
  origins().push_back(origin);
  return "allocation #" + std::to_string(origins().size()) + " (" + std::to_string(bytes) + " bytes)";
}

std::string originsOf(const std::string& text) {
  static const std::regex named("allocation #(\\d+)");
  std::string lines;
  std::set<size_t> said;
  for (std::sregex_iterator at(text.begin(), text.end(), named), end; at != end; ++at) {
    const size_t number = std::stoul((*at)[1]);
    if (number == 0 || number > origins().size() || !said.insert(number).second) continue;
    lines += "  allocation #" + std::to_string(number) + ": " + originOf(number) + "\n";
  }
  return lines;
}

}  // namespace gw::ptx
