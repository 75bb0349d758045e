// gpuwars devices: what can compute and what can draw here, which of them share memory, and what `auto` takes.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "game/cli/devices_options.h"
#include "game/commands/json_output.h"
#include "game/sim/kernel_target.h"
#include "gpu/devices/device_list.h"
#include "render/gl_renderers.h"

namespace gw {
namespace {

using Json = nlohmann::ordered_json;

std::string automaticWhy(const DeviceList& list) {
  return list.hasCuda() ? list.devices.front().name + " answers." : list.cudaMissing;
}

Json versionOrNull(int version) {
  return version == 0 ? Json() : Json(cudaVersionText(version));
}

Json toJson(const Processors& processors) {
  return {{"threads", processors.usable()},
          {"present", processors.present},
          {"allowed", processorList(processors.allowed)},
          {"quota", processors.quota ? Json(*processors.quota) : Json()}};
}

Json toJson(const DeviceInfo& device) {
  Json json{{"kind", device.kind}, {"name", device.name}, {"detail", device.detail}};
  if (device.kind == "cuda") {
    json["architecture"] = device.architecture;
    json["memory_MiB"] = device.memory_MiB;
    json["problem"] = device.problem;
  }
  return json;
}

Json toJson(const GlRenderer& renderer) {
  Json json{{"place", renderer.place}, {"name", renderer.name}, {"software", renderer.software}};
  json["sharesMemoryWithCuda"] = renderer.cudaDevice ? Json(*renderer.cudaDevice) : Json();
  return json;
}

Json toJson(const DeviceList& list, const std::vector<GlRenderer>& renderers) {
  Json json;
  json["auto"] = list.hasCuda() ? "cuda" : "cpu";
  json["autoWhy"] = automaticWhy(list);
  json["cudaMissing"] = list.cudaMissing;
  json["cudaState"] = nameOf(list.cudaState);
  json["driver"] = {{"release", list.driverRelease}, {"supportsCuda", versionOrNull(list.driverVersion)}};
  json["builtWithCuda"] = versionOrNull(list.runtimeVersion);
  json["cpuKernels"] = cpu::kernelTarget();
  json["devices"] = Json::array();
  for (const DeviceInfo& device : list.devices) json["devices"].push_back(toJson(device));
  json["processors"] = toJson(list.processors);
  json["renderers"] = Json::array();
  for (const GlRenderer& renderer : renderers) json["renderers"].push_back(toJson(renderer));
  return json;
}

void print(const DeviceList& list, const std::vector<GlRenderer>& renderers) {
  int ordinal = 0;
  for (const DeviceInfo& device : list.devices) {
    const bool cuda = device.kind == "cuda";
    const std::string kind = cuda ? "cuda " + std::to_string(ordinal++) : device.kind;
    std::printf("%-7s %s, %s\n", kind.c_str(), device.name.c_str(), device.detail.c_str());
    if (!device.problem.empty()) std::printf("%-7s %s.\n", "", device.problem.c_str());
  }
  std::printf("kernels of the cpu device: %s\n", cpu::kernelTarget());
  if (list.driverVersion != 0) {
    std::printf("driver  NVIDIA %s, for CUDA up to %s\n",
                list.driverRelease.empty() ? "(release not known)" : list.driverRelease.c_str(),
                cudaVersionText(list.driverVersion).c_str());
  }
  if (list.runtimeVersion != 0) std::printf("built   with CUDA %s\n", cudaVersionText(list.runtimeVersion).c_str());
  for (const GlRenderer& renderer : renderers) {
    std::printf("OpenGL  %s: %s%s", renderer.place.c_str(), renderer.name.empty() ? "none" : renderer.name.c_str(),
                renderer.software ? ", on the processor" : "");
    if (renderer.cudaDevice) std::printf(", shares memory with cuda %d", *renderer.cudaDevice);
    std::printf("\n");
  }
  if (renderers.empty()) std::printf("OpenGL  none without a display\n");
  std::printf("auto takes %s: %s\n", list.hasCuda() ? "cuda" : "cpu", automaticWhy(list).c_str());
}

}  // namespace

ExitCode runVerb(const DevicesOptions& options) {
  const DeviceList list = listDevices();
  const std::vector<GlRenderer> renderers = listGlRenderers();
  if (options.jsonPath.empty()) {
    print(list, renderers);
  } else {
    writeJson(options.jsonPath, toJson(list, renderers));
  }
  return ExitCode::fine;
}

}  // namespace gw
