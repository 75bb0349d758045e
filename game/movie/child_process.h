// Another program, run from an argument vector: no shell ever sees a file's name.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gw {

class ChildProcess {
 public:
  // Throws std::system_error when it cannot be started; ENOENT when it is not installed. It stands in a group of its
  // own, so that Ctrl-C at the terminal is ours alone.
  explicit ChildProcess(const std::vector<std::string>& arguments);
  ~ChildProcess();  // one that was not waited for is killed
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // To its standard input. False when it no longer reads.
  bool write(std::span<const uint8_t> bytes);
  // Ends its input and waits for it: its exit code, or 128 and the signal that ended it.
  int wait();
  // What it wrote to stdout and stderr; after wait().
  std::string output() const;

 private:
  void closeInput();

  pid_t pid_ = -1;
  int input_ = -1, output_ = -1;
};

}  // namespace gw
