// Text in SVG and HTML.
#pragma once

#include <string>
#include <string_view>

namespace gw::profile {

// Safe as content and in quoted attributes. Bytes that are no UTF-8 and characters that XML has no place for become
// U+FFFD: names of files may hold anything.
std::string xmlEscaped(std::string_view text);

// At most `characters` of it, an ellipsis for the rest; `text` is plain, and stays whole UTF-8.
std::string shortened(std::string_view text, size_t characters);

// How many characters it has.
size_t lengthOf(std::string_view text);

}  // namespace gw::profile
