// --json OUT: results for scripts.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace gw {

// "-" is stdout. Throws UserError when the file cannot be written.
void writeJson(const std::filesystem::path& path, const nlohmann::ordered_json& json);

}  // namespace gw
