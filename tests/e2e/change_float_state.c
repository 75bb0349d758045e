// Preloaded, it leaves threads in another floating-point state, as libraries that were linked with -ffast-math do.
// GW_FLOAT_BITS: what it adds to MXCSR or FPCR. GW_FLOAT_WHERE: "start" (the first thread, before main), "threads"
// (each one too, as it begins), "always" (also when a thread reads the clock).
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

static uint64_t bits = 0;
static int inThreads = 0, always = 0;

static void change(void) {
  if (bits == 0) return;
#if defined(__x86_64__)
  _mm_setcsr(_mm_getcsr() | (unsigned)bits);
#elif defined(__aarch64__)
  uint64_t control = 0;
  __asm__ volatile("mrs %0, fpcr" : "=r"(control));
  __asm__ volatile("msr fpcr, %0" : : "r"(control | bits));
#endif
}

__attribute__((constructor)) static void begin(void) {
  const char *wanted = getenv("GW_FLOAT_BITS"), *where = getenv("GW_FLOAT_WHERE");
  if (!wanted || !where) return;
  bits = strtoull(wanted, NULL, 0);
  always = strcmp(where, "always") == 0;
  inThreads = always || strcmp(where, "threads") == 0;
  change();
}

struct Thread {
  void* (*run)(void*);
  void* argument;
};

static void* changed(void* pointer) {
  const struct Thread thread = *(struct Thread*)pointer;
  free(pointer);
  change();
  return thread.run(thread.argument);
}

int pthread_create(pthread_t* id, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  static int (*real)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*) = NULL;
  if (!real) *(void**)&real = dlsym(RTLD_NEXT, "pthread_create");
  struct Thread* thread = inThreads ? malloc(sizeof *thread) : NULL;
  if (!thread) return real(id, attributes, run, argument);
  thread->run = run;
  thread->argument = argument;
  const int failed = real(id, attributes, changed, thread);
  if (failed) free(thread);
  return failed;
}

int clock_gettime(clockid_t clock, struct timespec* time) {
  static int (*real)(clockid_t, struct timespec*) = NULL;
  if (!real) *(void**)&real = dlsym(RTLD_NEXT, "clock_gettime");
  if (always) change();
  return real(clock, time);
}
