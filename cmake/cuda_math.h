// Before all else in CUDA files, where the C library is newer than nvcc: since glibc 2.42 <math.h> has an rsqrt() that
// never throws, and nvcc up to 13.0 has one of its own that might, which is an error. The C library's is not
// called here: instead of it, cos() is declared once more. In nvcc's first pass only: the second one's files hold the
// headers already.
#if defined(__CUDACC__) && !defined(GW_CUDA_MATH_H)
#define GW_CUDA_MATH_H
#define rsqrt cos
#include <math.h>
#undef rsqrt
#endif
