// --json OUT: results for scripts.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace gw {

// "-" is stdout. Throws FileError when the file cannot be written; what stood there is then untouched.
void writeJson(const std::filesystem::path& path, const nlohmann::ordered_json& json);

}  // namespace gw
