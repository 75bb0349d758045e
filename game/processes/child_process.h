// A program with which this one talks by lines: what it is told is its standard input, what it says its standard
// output. Its standard error is this program's.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace gw {

class ChildProcess {
 public:
  // Throws std::system_error when it cannot be started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  ~ChildProcess();  // closes its input, which ends it, and waits
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // False when it has ended.
  bool writeLine(const std::string& line);
  bool readLine(std::string& line);

 private:
  pid_t process_ = -1;
  int socket_ = -1;
  std::FILE* output_ = nullptr;  // reads from it
};

}  // namespace gw
