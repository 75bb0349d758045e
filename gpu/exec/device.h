// Function markers and the device namespace.
//
// Every kernel file is compiled once per device: as CUDA into gw::cuda, as C++ into gw::cpu (see
// cmake/gw_add_kernels.cmake). Any function with arithmetic in it lives in gw::GW_DEVICE, so that the
// linker can never merge two compilations of it; namespace gw itself holds plain data only.
#pragma once

#if __cplusplus < 202002L
#error "GpuWars needs C++20: compile with -std=c++20, or link the CMake target gpuwars::gpu."
#endif

#ifndef GW_DEVICE
#error "Kernel code needs GW_DEVICE (cpu or cuda): add the file by gw_add_kernels() in CMake, or define GW_DEVICE=cpu."
#endif

#ifdef __FAST_MATH__
#error "Results are bit for bit the same everywhere only without -ffast-math; leave that flag out."
#endif

#if defined(__CUDACC__) || defined(GW_STAND_IN_KERNELS)
#define GW_ON_CUDA 1
#define GW_FN __host__ __device__ inline
#define GW_MEMBER __host__ __device__
#define GW_BODY __device__
#else
#define GW_ON_CUDA 0  // 1 where this is compiled for the cuda device
#define GW_FN inline  // a function of arithmetic, which host code of the same device may call too
#define GW_MEMBER     // the same for members
#define GW_BODY       // kernel bodies and what only they may call
#endif
