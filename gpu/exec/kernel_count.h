// How many kernels this process has run on the cuda device: what a test or a report shows for its claim that a GPU took
// part. Counted when their queue has been waited for without an error, so a launch that failed is none.
#pragma once

#include <atomic>
#include <cstdint>

namespace gw {

// So far, of all queues.
inline std::atomic<uint64_t> cudaKernelsRun{0};

}  // namespace gw
