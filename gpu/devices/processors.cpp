#include <gpuwars/processors.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace gw {
namespace {

constexpr uint32_t kMostProcessors = 1u << 16;

// The kernel refuses a set that is smaller than its own, whose size it does not tell.
std::vector<uint32_t> affinity() {
  for (uint32_t size = 1024; size <= kMostProcessors; size *= 2) {
    cpu_set_t* set = CPU_ALLOC(size);
    if (set == nullptr) return {};
    const size_t bytes = CPU_ALLOC_SIZE(size);
    const bool told = sched_getaffinity(0, bytes, set) == 0;
    std::vector<uint32_t> allowed;
    for (uint32_t i = 0; told && i < size; ++i) {
      if (CPU_ISSET_S(i, bytes, set)) allowed.push_back(i);
    }
    CPU_FREE(set);
    if (told) return allowed;
  }
  return {};
}

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string number = text;
  number.erase(number.find_last_not_of('0') + 1);
  if (!number.empty() && (number.back() < '0' || number.back() > '9')) number.pop_back();
  return number;
}

}  // namespace

uint32_t Processors::usable() const {
  uint32_t count = present;
  if (!allowed.empty()) count = std::min(count, uint32_t(allowed.size()));
  if (quota) count = uint32_t(std::min(double(count), std::ceil(*quota)));
  return std::max(count, 1u);
}

std::string Processors::limits() const {
  const std::string of = " of " + std::to_string(present) + (present == 1 ? " processor" : " processors");
  std::string text;
  if (!allowed.empty() && allowed.size() < present) text = "an affinity to " + std::to_string(allowed.size()) + of;
  if (quota && *quota < present) text += (text.empty() ? "a quota of " : ", a quota of ") + shortNumber(*quota) + of;
  return text;
}

Processors readProcessors(const std::filesystem::path& root) {
  Processors processors;
  std::ifstream online(root / "sys/devices/system/cpu/online");
  std::string list;
  std::getline(online, list);
  const size_t listed = processorsInList(list).size();
  const long counted = sysconf(_SC_NPROCESSORS_ONLN);
  processors.present = listed > 0 ? uint32_t(listed) : uint32_t(std::max(1l, counted));
  processors.allowed = affinity();
  processors.quota = ProcessorQuota(root).processors();
  return processors;
}

std::vector<uint32_t> processorsInList(const std::string& list) {
  std::vector<uint32_t> processors;
  std::istringstream ranges(list);
  for (std::string range; std::getline(ranges, range, ',');) {
    unsigned first = 0, last = 0;
    const int read = std::sscanf(range.c_str(), "%u-%u", &first, &last);
    if (read < 1) continue;
    if (read == 1) last = first;
    for (; first <= last && first < kMostProcessors; ++first) processors.push_back(first);
  }
  return processors;
}

std::string processorList(const std::vector<uint32_t>& processors) {
  std::string list;
  for (size_t i = 0; i < processors.size();) {
    size_t end = i + 1;
    while (end < processors.size() && processors[end] == processors[end - 1] + 1) ++end;
    list += (list.empty() ? "" : ",") + std::to_string(processors[i]);
    if (end > i + 1) list += "-" + std::to_string(processors[end - 1]);
    i = end;
  }
  return list;
}

}  // namespace gw
