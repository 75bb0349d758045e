// While it lives, nothing reaches stderr: for libraries that cannot be told to be silent.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace gw {

class QuietStderr {
 public:
  QuietStderr() {
    std::fflush(stderr);
    kept_ = dup(STDERR_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~QuietStderr() {
    if (kept_ < 0) return;
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;

 private:
  int kept_ = -1;
};

}  // namespace gw
