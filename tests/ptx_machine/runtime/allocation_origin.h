// Where the program allocated device memory: for messages, which name an allocation by its number.
#pragma once

#include <cstddef>
#include <string>

namespace gw::ptx {

// Notes who calls, and names the new allocation: "allocation #12 (4096 bytes)". O(depth of the stack).
std::string nameAllocation(size_t bytes);

// A line for each allocation that the text names: the function and the line of the source that made it, as far as
// addr2line is there and the program has line numbers. Slow: it starts a program.
std::string originsOf(const std::string& text);

}  // namespace gw::ptx
