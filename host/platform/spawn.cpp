#include "host/platform/spawn.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include "host/platform/clock.h"

extern char** environ;

namespace gw {

pid_t spawn(const std::vector<std::string>& arguments, const ProgramStreams& streams) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  if (streams.in >= 0) posix_spawn_file_actions_adddup2(&files, streams.in, STDIN_FILENO);
  if (streams.out >= 0) posix_spawn_file_actions_adddup2(&files, streams.out, STDOUT_FILENO);
  if (streams.error >= 0) posix_spawn_file_actions_adddup2(&files, streams.error, STDERR_FILENO);

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
  pid_t program = -1;
  const int failed = posix_spawnp(&program, words[0], &files, &attributes, words.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  if (failed != 0) throw std::system_error(failed, std::generic_category());
  return program;
}

void endWithin(pid_t program, double seconds) {
  const double end_s = now_s() + seconds;
  while (now_s() < end_s) {
    const pid_t ended = waitpid(program, nullptr, WNOHANG);
    if (ended == program || (ended < 0 && errno != EINTR)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(-program, SIGKILL);
  waitFor(program);
}

int waitFor(pid_t program) {
  int status = 0;
  pid_t ended;
  while ((ended = waitpid(program, &status, 0)) < 0 && errno == EINTR) {
  }
  if (ended < 0) return 128;  // other code has waited for it, so its status is lost
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace gw
