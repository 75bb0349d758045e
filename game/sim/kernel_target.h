// Which processors the cpu device's kernels in use were compiled for: an installed game has them for several and takes
// the fastest at its start (docs/guide/building.md).
#pragma once

namespace gw::cpu {

// The newest level of x86-64 all of whose instructions they may use ("x86-64", "x86-64-v2", "x86-64-v3", "x86-64-v4"),
// or the name of another architecture.
const char* kernelTarget();

}  // namespace gw::cpu
