#include "game/commands/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

#include "host/platform/clock.h"

namespace gw {

Progress::Progress(std::string what, uint64_t of)
    : what_(std::move(what)), of_(of), terminal_(isatty(STDERR_FILENO) != 0), next_s_(now_s()) {}

Progress::~Progress() {
  clear();
}

void Progress::clear() {
  if (std::exchange(shown_, false)) std::fputs("\r\033[K", stderr);
}

void Progress::show(uint64_t done, const std::string& more) {
  if (!terminal_) return;
  if (now_s() < next_s_) return;
  next_s_ = now_s() + 0.2;
  std::fprintf(stderr, "\r\033[K%s: %llu of %llu%s", what_.c_str(), static_cast<unsigned long long>(done),
               static_cast<unsigned long long>(of_), more.c_str());
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace gw
