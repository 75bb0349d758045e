// A program with which this one talks by lines: what it is told is its standard input, what it says its standard
// output. Its standard error is this program's.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace gw {

class ChildProcess {
 public:
  using GiveUp = std::function<bool()>;

  // Throws std::system_error when it cannot be started. `giveUp` is asked now and then while it has nothing to say.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments, GiveUp giveUp);
  ~ChildProcess();  // closes its input, which ends it; kills what does not end by that
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // False when it has ended, or waiting was given up.
  bool writeLine(const std::string& line);
  bool readLine(std::string& line);

 private:
  pid_t process_ = -1;
  int socket_ = -1;
  GiveUp giveUp_;
  std::string heard_;  // and not yet read
};

}  // namespace gw
