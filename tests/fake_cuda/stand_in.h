// A stand-in for the CUDA runtime: the cuda device of GpuWars, on a machine without a GPU.
//
// The preset `stand-in` compiles every kernel file into gw::cuda as it is, but as C++, against the headers in include/,
// and links this library in place of the CUDA runtime. So the very code that a GPU would run is run: launches, graphs,
// pinned rings, shuffles and barriers, OpenGL interop, and what is done when any of it fails. It is no GPU: what it
// proves is results and the order of calls, never speed, memory limits or races between blocks.
//
// What it is strict about, because a GPU would forgive it here and punish it there:
//   - Work is lazy: it is done when a caller waits for it, as late as CUDA allows. Who reads pinned memory without
//     waiting reads nothing new; who overwrites a pinned source too early sends the new bytes.
//   - While a stream is captured, what CUDA forbids is an error: allocating, freeing, waiting.
//   - Memory is full of 0xA5 at first, and ends at a page that must not be touched.
//   - Blocks, and threads up to the first barrier, run in reversed order when asked to: see options below.
//   - A copy must lie within what was allocated, on the side that its direction says.
//   - After a sticky error every call fails, and device and pinned memory are lost.
//
// Streams, graphs, events, pinned memory, faults and interop are the PTX machine's too (device_seam.h): there kernels
// are what nvcc compiled, and the variable is GW_PTX_MACHINE.
//
// Options come from the environment, so that the game itself can be run with them: GW_CUDA_STAND_IN is a list, with
// commas, of
//   eager            work is done at once
//   reversed         the order of blocks and threads
//   apart            OpenGL draws on "another GPU"
//   fault=CALL:N:E   the Nth call of CALL (or of any call, when CALL is *) returns error E in place of being made
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cuda_runtime_api.h"

namespace gw::stand_in {

struct Fault {
  std::string call = "*";  // "cudaMalloc"; "*": any
  uint64_t number = 0;     // counting from 1; 0: never
  cudaError_t error = cudaErrorUnknown;
};

struct Options {
  bool eager = false, reversed = false, apart = false;
  Fault fault{};
};

// What the environment says; who cannot be understood ends the program with one sentence.
Options optionsFromEnvironment();

// A new driver: no streams, no memory, nothing counted. For tests, between runs; whatever of the old one is still
// held must not be used, and what destructors give back is ignored.
void restart(const Options& options);

// Calls so far, all and by name; those that only ask for error texts are not counted.
uint64_t calls();
const std::map<std::string, uint64_t>& callsByName();
// Their names, in order; the first is call 1.
const std::vector<std::string>& callLog();
// What the fault struck: the call's name, or empty when it has not come to it.
std::string struck();
uint64_t kernelsRun();
// OpenGL's buffers that a living context has in its hands.
uint64_t resourcesLeftMapped();

}  // namespace gw::stand_in
