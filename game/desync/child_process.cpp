#include "game/desync/child_process.h"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

extern char** environ;

namespace gw {
namespace {

// Writing to a pair of sockets can be told not to raise SIGPIPE; both ends vanish when a program is started.
struct Pair {
  int own = -1, theirs = -1;

  Pair() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
      throw std::system_error(errno, std::generic_category());
    }
    own = ends[0];
    theirs = ends[1];
  }
};

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  std::string name = program.string();
  std::vector<std::string> words = arguments;
  std::vector<char*> argv{name.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const Pair pair;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pair.theirs, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pair.theirs, STDOUT_FILENO);
  const int error = posix_spawnp(&process_, name.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(pair.theirs);
  if (error != 0) {
    close(pair.own);
    throw std::system_error(error, std::generic_category());
  }
  socket_ = pair.own;
  output_ = fdopen(socket_, "r");
}

ChildProcess::~ChildProcess() {
  shutdown(socket_, SHUT_WR);
  std::fclose(output_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
}

bool ChildProcess::writeLine(const std::string& line) {
  const std::string whole = line + "\n";
  for (size_t sent = 0; sent < whole.size();) {
    const ssize_t now = send(socket_, whole.data() + sent, whole.size() - sent, MSG_NOSIGNAL);
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) return false;
    sent += size_t(now);
  }
  return true;
}

bool ChildProcess::readLine(std::string& line) {
  char* text = nullptr;
  size_t room = 0;
  const ssize_t length = getline(&text, &room, output_);
  if (length > 0) line.assign(text, size_t(length) - (text[length - 1] == '\n' ? 1 : 0));
  std::free(text);
  return length > 0;
}

}  // namespace gw
