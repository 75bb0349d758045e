// The floating-point state of a thread: how it rounds, and whether it keeps subnormals. Kernels, rule tables and
// pictures are defined for one state only, but a thread inherits its creator's, and a library that is loaded may change
// it (one linked with -ffast-math flushes subnormals from then on). So main() and every thread set it before they
// compute, and the cpu device does so on each of its threads at every launch.
#pragma once

namespace gw {

// Round to nearest, ties to even; subnormals kept as operands and results; no exception trapped. x86-64: MXCSR, and the
// control word of x87, by which strtod() and printf() round. AArch64: FPCR. Flags of past exceptions do not count.
bool floatStateIsDefault();

// Sets it for the calling thread. Returns false when it had been changed.
bool setFloatState();

}  // namespace gw
