// The line that says where a figure was measured: processor, cores, compiler.
#pragma once

#include <fstream>
#include <string>
#include <thread>

namespace gw {

inline std::string machineLine() {
  std::string model = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  }
  return "Machine: " + model + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores; g++ " +
         __VERSION__ + ".";
}

}  // namespace gw
