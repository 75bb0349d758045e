#include "game/replay/replay_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "game/replay/replay_header.h"

namespace gw {

Replay readReplay(const std::filesystem::path& path, SimulationVersions versions, Completeness completeness) {
  namespace fs = std::filesystem;
  const std::string name = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw ReplayError(fmt::format("{}: there is no such file; check its name", name));
  if (!fs::is_regular_file(status)) {
    throw ReplayError(fmt::format("{}: this is not a plain file; name a file that --record wrote", name));
  }
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? std::streamoff(file.tellg()) : -1;
  if (size < 0) {
    throw ReplayError(fmt::format("{}: the file cannot be read ({}); give yourself the right to read it", name,
                                  std::strerror(errno)));
  }
  refuseTooLarge(uint64_t(size), ReplayRefusal(name));
  std::vector<uint8_t> bytes(static_cast<size_t>(size));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
  if (size_t(file.gcount()) != bytes.size()) {
    throw ReplayError(fmt::format("{}: reading failed; check the disk or copy the file again", name));
  }
  return decodeReplay(bytes, name, versions, completeness);
}

}  // namespace gw
