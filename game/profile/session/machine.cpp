#include "game/profile/session/machine.h"

#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "game/profile/session/built_from.h"
#include "gpu/devices/processors.h"
#include "host/platform/clock.h"
#include "host/platform/piped_process.h"

namespace gw::profile {
namespace {

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
  double value = kUnknown;  // in the driver's way, whatever the locale
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
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
  machine.cores = std::to_string(readProcessors().present);
  machine.compiler = kCompiler;
  machine.flags = kCompilerFlags;
  machine.commit = kCommit;
  utsname system{};
  if (uname(&system) == 0) machine.system = std::string(system.sysname) + " " + system.release + " " + system.machine;
  machine.loadBefore = loadAverage();
  return machine;
}

std::optional<GpuState> gpuStateIn(const std::string& lines, const std::string& device) {
  std::istringstream all(lines);
  std::optional<GpuState> first;
  for (std::string line; std::getline(all, line);) {
    std::istringstream row(line);
    std::vector<std::string> words;
    for (std::string word; std::getline(row, word, ',');) words.push_back(trimmed(word));
    if (words.size() != 5) continue;
    const GpuState state{words[0], words[1], numberIn(words[2]), numberIn(words[3]), numberIn(words[4])};
    if (device.find(state.name) != std::string::npos) return state;
    if (!first) first = state;
  }
  return first;
}

std::optional<GpuState> askGpu(const std::string& device) {
  try {
    PipedProcess tool({"nvidia-smi", "--query-gpu=name,driver_version,clocks.sm,power.draw,temperature.gpu",
                       "--format=csv,noheader,nounits"});
    if (tool.wait() == 0) return gpuStateIn(tool.output(), device);
  } catch (const std::system_error&) {
  }
  return std::nullopt;
}

void tellGpu(Machine& machine, const std::vector<GpuState>& states) {
  if (states.empty()) return;
  machine.gpu = states.back().name;
  machine.driver = states.back().driver;
  const auto meanOf = [&](double GpuState::*of) {
    std::vector<double> values;
    for (const GpuState& state : states) {
      if (std::isfinite(state.*of)) values.push_back(state.*of);
    }
    return values.empty() ? kUnknown : mean(values);
  };
  machine.gpuClock_MHz = meanOf(&GpuState::clock_MHz);
  machine.gpuPower_W = meanOf(&GpuState::power_W);
  machine.gpuTemperature_C = meanOf(&GpuState::temperature_C);
}

// What /proc/stat counts in is the machine's, whatever of it this process may use.
uint32_t processorsIn(std::istream& stat) {
  uint32_t count = 0;
  for (std::string line; std::getline(stat, line);) {
    count += line.starts_with("cpu") && line.size() > 3 && line[3] >= '0' && line[3] <= '9';
  }
  return count;
}

MachineUse::MachineUse() : busy_s_(busySeconds()), own_s_(ownSeconds()), wall_s_(now_s()) {}

double MachineUse::othersShare() const {
  const double others_s = busySeconds() - busy_s_ - (ownSeconds() - own_s_);
  std::ifstream stat("/proc/stat");
  const double all_s = (now_s() - wall_s_) * std::max(1u, processorsIn(stat));
  return all_s > 0 ? std::clamp(others_s / all_s, 0.0, 1.0) : kUnknown;
}

}  // namespace gw::profile
