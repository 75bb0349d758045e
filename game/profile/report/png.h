// Pictures as PNG, by rsvg-convert where it is installed.
#pragma once

#include <filesystem>
#include <string>

namespace gw::profile {

// Writes the PNG whole or not at all. False when rsvg-convert is not installed; throws UserError when it fails.
bool writePngOf(const std::string& svg, const std::filesystem::path& path);

inline constexpr const char* kNoPng =
    "There is no rsvg-convert, so the pictures are SVG only: install it (Debian, Ubuntu: apt install librsvg2-bin) to "
    "get them as PNG too.";

}  // namespace gw::profile
