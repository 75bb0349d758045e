#include "host/platform/interrupt.h"

#include <csignal>

#include "host/platform/clock.h"
#include "host/platform/unfinished_file.h"

namespace gw {

namespace {

constexpr double kSame_s = 0.25;  // signals closer than this are one wish

struct Caught {
  int signal;
  volatile std::sig_atomic_t times;
  double first_s;
};

Caught caughtSignals[] = {{SIGINT, 0, 0}, {SIGTERM, 0, 0}, {SIGHUP, 0, 0}};
volatile std::sig_atomic_t firstSignal = 0;

// Only what is async-signal-safe.
void onSignal(int signal) {
  if (firstSignal == 0) firstSignal = signal;
  for (Caught& caught : caughtSignals) {
    if (caught.signal != signal) continue;
    if (caught.times == 0) {
      caught.times = 1;
      caught.first_s = now_s();
    } else if (signal != SIGHUP && now_s() - caught.first_s > kSame_s) {  // the system itself repeats SIGHUP
      removeUnfinishedFiles();
      std::signal(signal, SIG_DFL);
      std::raise(signal);
    }
  }
}

}  // namespace

void catchInterrupts() {
  for (const Caught& caught : caughtSignals) {
    struct sigaction before {};
    if (caught.signal == SIGHUP && sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    std::signal(caught.signal, onSignal);
  }
}

bool interrupted() {
  return firstSignal != 0;
}

int exitStatus(int code) {
  constexpr int kFine = 0, kFailedRun = 1;
  return interrupted() && (code == kFine || code == kFailedRun) ? 128 + firstSignal : code;
}

}  // namespace gw
