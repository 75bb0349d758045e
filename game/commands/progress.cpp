#include "game/commands/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace gw {

Progress::Progress(std::string what, uint64_t of)
    : what_(std::move(what)), of_(of), terminal_(isatty(STDERR_FILENO) != 0), next_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  clear();
}

void Progress::clear() {
  if (std::exchange(shown_, false)) std::fputs("\r\033[K", stderr);
}

void Progress::show(uint64_t done, const std::string& more) {
  if (!terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(200);
  std::fprintf(stderr, "\r\033[K%s: %llu of %llu%s", what_.c_str(), static_cast<unsigned long long>(done),
               static_cast<unsigned long long>(of_), more.c_str());
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace gw
