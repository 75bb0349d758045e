#include "game/profile/session/machine.h"

#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <system_error>
#include <thread>
#include <vector>

#include "game/processes/fed_process.h"
#include "game/profile/session/built_from.h"

namespace gw::profile {
namespace {

double clock_s() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

// Of all processors since the system started; unknown where it does not say.
double busySeconds() {
  std::ifstream stat("/proc/stat");
  std::string word;
  double user, nice, system, idle, wait, irq, softIrq, steal;
  if (!(stat >> word >> user >> nice >> system >> idle >> wait >> irq >> softIrq >> steal) || word != "cpu") {
    return kUnknown;
  }
  return (user + nice + system + irq + softIrq + steal) / double(sysconf(_SC_CLK_TCK));
}

// Of this process and those that it has waited for.
double ownSeconds() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage use{};
    getrusage(who, &use);
    sum +=
        double(use.ru_utime.tv_sec + use.ru_stime.tv_sec) + double(use.ru_utime.tv_usec + use.ru_stime.tv_usec) * 1e-6;
  }
  return sum;
}

std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  }
  return "";
}

std::string trimmed(const std::string& text) {
  const size_t first = text.find_first_not_of(" \n\t"), last = text.find_last_not_of(" \n\t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

double numberIn(const std::string& text) {
  try {
    return std::stod(text);
  } catch (const std::exception&) {
    return kUnknown;
  }
}

}  // namespace

double loadAverage() {
  std::ifstream file("/proc/loadavg");
  double load = kUnknown;
  return file >> load ? load : kUnknown;
}

Machine thisMachine() {
  Machine machine;
  machine.cpu = processorName();
  machine.cores = std::to_string(std::thread::hardware_concurrency());
  machine.compiler = kCompiler;
  machine.flags = kCompilerFlags;
  machine.commit = kCommit;
  utsname system{};
  if (uname(&system) == 0) machine.system = std::string(system.sysname) + " " + system.release + " " + system.machine;
  machine.loadBefore = loadAverage();
  return machine;
}

void askGpu(Machine& machine) {
  try {
    FedProcess tool({"nvidia-smi", "--query-gpu=name,driver_version,clocks.sm,power.draw,temperature.gpu",
                     "--format=csv,noheader,nounits"});
    if (tool.wait() != 0) return;
    std::istringstream line(tool.output());
    std::vector<std::string> words;
    for (std::string word; std::getline(line, word, ',') && words.size() < 5;) words.push_back(trimmed(word));
    if (words.size() < 5) return;
    machine.gpu = words[0];
    machine.driver = words[1];
    machine.gpuClock_MHz = numberIn(words[2]);
    machine.gpuPower_W = numberIn(words[3]);
    machine.gpuTemperature_C = numberIn(words[4].substr(0, words[4].find('\n')));
  } catch (const std::system_error&) {
  }
}

MachineUse::MachineUse() : busy_s_(busySeconds()), own_s_(ownSeconds()), wall_s_(clock_s()) {}

double MachineUse::othersShare() const {
  const double others_s = busySeconds() - busy_s_ - (ownSeconds() - own_s_);
  const double all_s = (clock_s() - wall_s_) * std::max(1u, std::thread::hardware_concurrency());
  return all_s > 0 ? std::clamp(others_s / all_s, 0.0, 1.0) : kUnknown;
}

}  // namespace gw::profile
