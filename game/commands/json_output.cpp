#include "game/commands/json_output.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/platform/atomic_file.h"

namespace gw {

void writeJson(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
  // Names of files may hold any bytes; JSON may not.
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (path == "-") {
    std::cout << text << std::flush;
    return;
  }
  writeFileAtomically(path, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

}  // namespace gw
