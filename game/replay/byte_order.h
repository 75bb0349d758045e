// Little-endian numbers in bytes, one by one: the file never sees a struct's layout.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gw {

template <std::unsigned_integral T>
void putLittle(std::vector<uint8_t>& bytes, T value) {
  for (size_t i = 0; i < sizeof(T); ++i) bytes.push_back(uint8_t(value >> (8 * i)));
}

// Overwrites; the bytes must be there.
template <std::unsigned_integral T>
void putLittleAt(std::vector<uint8_t>& bytes, size_t offset, T value) {
  for (size_t i = 0; i < sizeof(T); ++i) bytes[offset + i] = uint8_t(value >> (8 * i));
}

// The caller has checked that the bytes are there.
template <std::unsigned_integral T>
T getLittle(std::span<const uint8_t> bytes, size_t offset) {
  T value = 0;
  for (size_t i = 0; i < sizeof(T); ++i) value = T(value | T(bytes[offset + i]) << (8 * i));
  return value;
}

}  // namespace gw
