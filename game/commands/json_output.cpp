#include "game/commands/json_output.h"

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "game/user_error.h"

namespace gw {

void writeJson(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
  // Names of files may hold any bytes; JSON may not.
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (path == "-") {
    std::cout << text << std::flush;
    return;
  }
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) {
    throw UserError(ExitCode::badFile, "Cannot write " + path.string() + ": choose another place with --json.");
  }
}

}  // namespace gw
