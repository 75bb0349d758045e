#include "game/interrupt.h"

#include <csignal>

namespace gw {

namespace {

volatile std::sig_atomic_t wished = 0;

void onSignal(int signal) {
  wished = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catchInterrupts() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

bool interrupted() {
  return wished != 0;
}

}  // namespace gw
