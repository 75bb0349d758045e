// Text in SVG, HTML and XML.
#pragma once

#include <string>
#include <string_view>

namespace gw::profile {

// The text with U+FFFD for each byte that is not UTF-8 or belongs to a character that XML does not allow.
std::string xmlCharacters(std::string_view text);

// The same, escaped: safe as content and in quoted attributes.
std::string xmlEscaped(std::string_view text);

// At most `characters` of it, with an ellipsis for the rest; `text` is plain, and stays whole UTF-8.
std::string shortened(std::string_view text, size_t characters);

// The number of its characters.
size_t lengthOf(std::string_view text);

}  // namespace gw::profile
