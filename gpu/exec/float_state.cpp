#include <gpuwars/float_state.h>

#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace gw {

#if defined(__x86_64__)

namespace {

constexpr uint32_t kMxcsr = 0x1f80, kPastExceptions = 0x3f;  // all masked, to nearest, no FTZ, no DAZ
constexpr uint16_t kX87Control = 0x037f;                     // all masked, to nearest, 64 bits of mantissa

uint16_t x87Control() {
  uint16_t control = 0;
  asm volatile("fnstcw %0" : "=m"(control));
  return control;
}

}  // namespace

bool floatStateIsDefault() {
  return (_mm_getcsr() & ~kPastExceptions) == kMxcsr && x87Control() == kX87Control;
}

bool setFloatState() {
  if (floatStateIsDefault()) return true;
  _mm_setcsr(kMxcsr);
  asm volatile("fnclex\n\tfldcw %0" : : "m"(kX87Control));  // a pending exception would be raised by what comes next
  return false;
}

#elif defined(__aarch64__)

// Every field of FPCR is an alternative to what is wanted: RMode, FZ, FZ16, FIZ, DN, AHP, AH, NEP, and the traps.
bool floatStateIsDefault() {
  uint64_t control = 0;
  asm volatile("mrs %0, fpcr" : "=r"(control));
  return control == 0;
}

bool setFloatState() {
  if (floatStateIsDefault()) return true;
  asm volatile("msr fpcr, %0" : : "r"(uint64_t{0}));
  return false;
}

#else

bool floatStateIsDefault() {
  return std::fegetround() == FE_TONEAREST;
}

bool setFloatState() {
  if (floatStateIsDefault()) return true;
  std::fesetenv(FE_DFL_ENV);
  return false;
}

#endif

}  // namespace gw
