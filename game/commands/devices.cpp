// gpuwars devices: what there is, and what `auto` takes.
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "game/commands/commands.h"
#include "game/commands/json_output.h"
#include "gpu/device_list.h"

namespace gw {

ExitCode listDevicesCommand(const Options& options) {
  const DeviceList list = listDevices();
  const std::string automatic = list.hasCuda() ? "cuda" : "cpu";
  if (!options.jsonPath.empty()) {
    nlohmann::ordered_json json;
    json["auto"] = automatic;
    json["cudaMissing"] = list.cudaMissing;
    json["devices"] = nlohmann::ordered_json::array();
    for (const DeviceInfo& device : list.devices) {
      json["devices"].push_back({{"kind", device.kind}, {"name", device.name}, {"detail", device.detail}});
    }
    writeJson(options.jsonPath, json);
    return ExitCode::fine;
  }
  for (const DeviceInfo& device : list.devices) {
    std::printf("%-5s %s, %s\n", device.kind.c_str(), device.name.c_str(), device.detail.c_str());
  }
  if (!list.hasCuda()) std::printf("No cuda: %s\n", list.cudaMissing.c_str());
  std::printf("auto takes %s\n", automatic.c_str());
  return ExitCode::fine;
}

}  // namespace gw
