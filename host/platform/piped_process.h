// Another program that is fed by its standard input.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gw {

class PipedProcess {
 public:
  // Throws std::system_error as spawn() does.
  explicit PipedProcess(const std::vector<std::string>& arguments);
  ~PipedProcess();  // one that was not waited for is killed
  PipedProcess(const PipedProcess&) = delete;
  PipedProcess& operator=(const PipedProcess&) = delete;

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
