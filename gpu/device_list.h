// Which devices there are, what `auto` takes and why.
#pragma once

#include <string>
#include <vector>

namespace gw {

struct DeviceInfo {
  std::string kind;  // "cuda" or "cpu"
  std::string name;
  std::string detail;  // one line: capability and memory, or threads
};

struct DeviceList {
  std::vector<DeviceInfo> devices;  // cuda ones first; the cpu device is always there
  std::string cudaMissing;          // why there is no cuda device, one sentence; empty when there is one
  bool hasCuda() const { return cudaMissing.empty(); }
};

// Asks the driver; any error counts as "no device". Never throws.
DeviceList listDevices();

}  // namespace gw
