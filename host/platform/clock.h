// The one clock of the program. A simulation never reads it. clock_gettime is async-signal-safe, so signal handlers may
// use it too.
#pragma once

#include <time.h>

#include <cstdint>

namespace gw {

inline double readClock_s(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// Steady: of use for differences only.
inline double now_s() {
  return readClock_s(CLOCK_MONOTONIC);
}
inline double now_ms() {
  return 1e3 * now_s();
}

// Processor time of the calling thread, and of all threads of the program.
inline double threadTime_s() {
  return readClock_s(CLOCK_THREAD_CPUTIME_ID);
}
inline double processTime_s() {
  return readClock_s(CLOCK_PROCESS_CPUTIME_ID);
}

// Since 1970. May jump: not for differences.
inline uint64_t wallClock_ns() {
  timespec time{};
  clock_gettime(CLOCK_REALTIME, &time);
  return uint64_t(time.tv_sec) * 1'000'000'000 + uint64_t(time.tv_nsec);
}

}  // namespace gw
