// The PTX in a fat binary: what nvcc puts into an object beside the host's code, and the object registers.
//
// NVIDIA documents the wrapper only (fatbinary_section.h of the toolkit). What it points to is, as nvcc 13 writes it
// with
// --no-compress, all numbers little-endian:
//
//   header  u32 0xBA55ED50 | u16 version | u16 header's bytes | u64 bytes behind it
//   entry   u16 kind (1: PTX) | u16 version | u32 header's bytes | u64 bytes behind it | u32 compressed bytes (0: none)
//   |
//           u32 .. | u16 minor, u16 major PTX version | u32 architecture | ...
//   the entry's text, filled up with zeros; the next entry
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace gw::ptx {

struct EmbeddedPtx {
  uint32_t architecture = 0;  // 90
  std::string_view text;      // within the fat binary
};

// `wrapper`: the __fatBinC_Wrapper_t that __cudaRegisterFatBinary receives. Machine code beside the PTX is passed over.
// Throws PtxError when it is not laid out so, or is compressed.
std::vector<EmbeddedPtx> embeddedPtx(const void* wrapper);

// The same from what stands in an object's section .nv_fatbin, which may hold several.
std::vector<EmbeddedPtx> embeddedPtxOfSection(std::string_view section);

}  // namespace gw::ptx
