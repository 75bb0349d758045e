#include "host/platform/piped_process.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include "host/platform/spawn.h"

namespace gw {

PipedProcess::PipedProcess(const std::vector<std::string>& arguments) {
  std::signal(SIGPIPE, SIG_IGN);  // one that dies early is noticed by write()
  int ends[2];
  output_ = memfd_create("output", MFD_CLOEXEC);
  if (output_ < 0 || pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
  input_ = ends[1];

  try {
    pid_ = spawn(arguments, {ends[0], output_, output_});
  } catch (const std::system_error&) {
    close(ends[0]);
    closeInput();
    close(output_);
    throw;
  }
  close(ends[0]);
}

PipedProcess::~PipedProcess() {
  closeInput();
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    wait();
  }
  close(output_);
}

void PipedProcess::closeInput() {
  if (input_ >= 0) close(input_);
  input_ = -1;
}

bool PipedProcess::write(std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(input_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(size_t(written));
  }
  return true;
}

int PipedProcess::wait() {
  closeInput();
  return waitFor(std::exchange(pid_, -1));
}

std::string PipedProcess::output() const {
  std::string text;
  char part[4096];
  for (off_t at = 0;;) {
    const ssize_t got = pread(output_, part, sizeof part, at);
    if (got <= 0) return text;
    text.append(part, size_t(got));
    at += got;
  }
}

}  // namespace gw
