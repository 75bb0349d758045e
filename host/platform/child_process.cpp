#include "host/platform/child_process.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "host/platform/spawn.h"

namespace gw {
namespace {

constexpr int kAsk_ms = 100;      // between two looks whether to go on waiting
constexpr double kGrace_s = 2.0;  // to end by itself once it is not asked any more

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

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           GiveUp giveUp)
    : giveUp_(std::move(giveUp)) {
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
}

ChildProcess::~ChildProcess() {
  close(socket_);
  endWithin(process_, kGrace_s);
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
  for (size_t looked = 0;;) {
    if (const size_t end = heard_.find('\n', looked); end != std::string::npos) {
      line = heard_.substr(0, end);
      heard_.erase(0, end + 1);
      return true;
    }
    looked = heard_.size();
    pollfd ready{socket_, POLLIN, 0};
    if (poll(&ready, 1, kAsk_ms) <= 0) {
      if (giveUp_ && giveUp_()) return false;
      continue;
    }
    char part[65536];
    const ssize_t length = recv(socket_, part, sizeof part, 0);
    if (length < 0 && errno == EINTR) continue;
    if (length <= 0) return false;
    heard_.append(part, size_t(length));
  }
}

}  // namespace gw
