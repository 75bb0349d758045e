// How far long work is, on stderr, when that is a terminal; silent otherwise.
#pragma once

#include <cstdint>
#include <string>

namespace gw {

class Progress {
 public:
  Progress(std::string what, uint64_t of);
  ~Progress();  // wipes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Removes its line, so that something else can be printed there.
  void clear();

  // Cheap: writes a few times a second. `more` follows the count.
  void show(uint64_t done, const std::string& more = {});

 private:
  std::string what_;
  uint64_t of_;
  bool terminal_, shown_ = false;
  double next_s_;
};

}  // namespace gw
