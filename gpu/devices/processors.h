// How many processors this process may use: the least of those that are there, of its affinity (taskset, a container's
// set of processors) and of its quota of time (a container's or a service's share).
#pragma once

#include <gpuwars/processor_quota.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gw {

// What limits the threads of this process.
struct Processors {
  uint32_t present = 1;           // that the system has switched on
  std::vector<uint32_t> allowed;  // on which the calling thread, and all that it starts, may run
  std::optional<double> quota;    // the time of how many processors; nothing: no limit

  uint32_t usable() const;     // threads that can run at once: the quota counts as begun processors. At least 1
  std::string limits() const;  // what makes them fewer, e.g. "a quota of 1.5 of 8 processors"; empty: nothing does
};

// `root` holds /proc and /sys: tests give another one. The affinity is asked of the system itself.
Processors readProcessors(const std::filesystem::path& root = "/");

// "0-3,8", as Linux writes lists of processors.
std::vector<uint32_t> processorsInList(const std::string& list);
// The other way round.
std::string processorList(const std::vector<uint32_t>& processors);

}  // namespace gw
