#include "game/processes/child_process.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "game/processes/spawn.h"

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
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const Pair pair;
  try {
    process_ = spawn(words, {pair.theirs, pair.theirs});
  } catch (const std::system_error&) {
    close(pair.theirs);
    close(pair.own);
    throw;
  }
  close(pair.theirs);
  socket_ = pair.own;
  output_ = fdopen(socket_, "r");
}

ChildProcess::~ChildProcess() {
  shutdown(socket_, SHUT_WR);
  std::fclose(output_);
  waitFor(process_);
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
