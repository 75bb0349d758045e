// Who decides how fast the processors' clocks are, and within which limits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gw::profile {

// Texts are empty where the system does not say, as in most virtual machines.
struct Clocks {
  std::string governor;  // "performance"; several: "performance, powersave"
  std::string turbo;     // "on", "off"
  std::string range;     // "800 to 3400 MHz"; fixed: "2400 MHz"
  // Nothing but heat and turbo changes them: the governor is "performance", or there is one clock to choose from.
  bool fixed = true;
};

// Of these processors. `root` holds /sys: tests give another one.
Clocks readClocks(const std::vector<uint32_t>& processors, const std::filesystem::path& root = "/");

}  // namespace gw::profile
