#include "game/profile/session/clocks.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>

namespace gw::profile {
namespace {

namespace fs = std::filesystem;

std::string wordIn(const fs::path& path) {
  std::ifstream file(path);
  std::string word;
  file >> word;
  return word;
}

double numberIn(const fs::path& path) {
  std::ifstream file(path);
  double number = 0;
  return file >> number ? number : std::numeric_limits<double>::quiet_NaN();
}

std::string onOff(bool on) {
  return on ? "on" : "off";
}

// intel_pstate counts the other way round; amd_pstate may say it of each processor alone.
std::string turboOf(const std::set<fs::path>& policies, const fs::path& folder) {
  if (const std::string no = wordIn(folder / "intel_pstate/no_turbo"); !no.empty()) return onOff(no == "0");
  if (const std::string boost = wordIn(folder / "cpufreq/boost"); !boost.empty()) return onOff(boost != "0");
  std::set<std::string> all;
  for (const fs::path& policy : policies) {
    if (const std::string boost = wordIn(policy / "boost"); !boost.empty()) all.insert(onOff(boost != "0"));
  }
  return all.empty() ? "" : all.size() == 1 ? *all.begin() : "on and off";
}

std::string rangeText(double least_kHz, double most_kHz) {
  if (!(least_kHz <= most_kHz)) return "";
  const std::string most = std::to_string(std::lround(most_kHz / 1000)) + " MHz";
  return least_kHz == most_kHz ? most : std::to_string(std::lround(least_kHz / 1000)) + " to " + most;
}

}  // namespace

Clocks readClocks(const std::vector<uint32_t>& processors, const fs::path& root) {
  const fs::path folder = root / "sys/devices/system/cpu";
  Clocks clocks;
  std::set<fs::path> policies;
  std::set<std::string> governors;
  double least_kHz = std::numeric_limits<double>::infinity(), most_kHz = -least_kHz;
  for (const uint32_t processor : processors) {
    const fs::path policy = folder / ("cpu" + std::to_string(processor)) / "cpufreq";
    const std::string governor = wordIn(policy / "scaling_governor");
    if (governor.empty()) continue;
    policies.insert(policy);
    governors.insert(governor);
    const double least = numberIn(policy / "scaling_min_freq"), most = numberIn(policy / "scaling_max_freq");
    clocks.fixed = clocks.fixed && (governor == "performance" || least == most);
    if (!(least <= most)) continue;
    least_kHz = std::min(least_kHz, least);
    most_kHz = std::max(most_kHz, most);
  }
  for (const std::string& governor : governors) clocks.governor += (clocks.governor.empty() ? "" : ", ") + governor;
  clocks.turbo = turboOf(policies, folder);
  clocks.range = rangeText(least_kHz, most_kHz);
  return clocks;
}

}  // namespace gw::profile
