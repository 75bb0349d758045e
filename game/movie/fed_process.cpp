#include "game/movie/fed_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

extern char** environ;

namespace gw {

FedProcess::FedProcess(const std::vector<std::string>& arguments) {
  std::signal(SIGPIPE, SIG_IGN);  // one that dies early is noticed by write()
  int ends[2];
  output_ = memfd_create("output", MFD_CLOEXEC);
  if (output_ < 0 || pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
  input_ = ends[1];

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, output_, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, output_, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t usual;
  sigemptyset(&usual);
  sigaddset(&usual, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);

  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const int failed = posix_spawnp(&pid_, words[0], &files, &attributes, words.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  close(ends[0]);
  if (failed == 0) return;
  closeInput();
  close(output_);
  throw std::system_error(failed, std::generic_category());
}

FedProcess::~FedProcess() {
  closeInput();
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    wait();
  }
  close(output_);
}

void FedProcess::closeInput() {
  if (input_ >= 0) close(input_);
  input_ = -1;
}

bool FedProcess::write(std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(input_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(size_t(written));
  }
  return true;
}

int FedProcess::wait() {
  closeInput();
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string FedProcess::output() const {
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
