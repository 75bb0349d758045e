#include <gpuwars/device_list.h>

#include <utility>

#ifdef GW_HAVE_CUDA
#include <cuda_runtime_api.h>

#include <fstream>
#include <iterator>
#endif

namespace gw {
namespace {

#ifdef GW_HAVE_CUDA
std::string installedRelease() {
  std::ifstream file("/proc/driver/nvidia/version");
  return driverReleaseIn(std::string(std::istreambuf_iterator<char>(file), {}));
}

void addCudaDevices(DeviceList& list) {
  CudaAnswers answers;
  answers.runtimeVersion = CUDART_VERSION;
  answers.driverRelease = installedRelease();
  answers.oldestArchitecture = oldestOf(GW_CUDA_ARCHITECTURES);
  int count = 0;
  cudaError_t error = cudaDriverGetVersion(&answers.driverVersion);  // 0 where there is none
  if (error == cudaSuccess) error = cudaGetDeviceCount(&count);
  for (int i = 0; error == cudaSuccess && i < count; ++i) {
    cudaDeviceProp properties{};
    error = cudaGetDeviceProperties(&properties, i);
    if (error != cudaSuccess) break;
    DeviceInfo device{"cuda", properties.name};
    device.architecture = properties.major * 10 + properties.minor;
    device.memory_MiB = properties.totalGlobalMem >> 20;
    device.detail = "sm_" + std::to_string(device.architecture) + ", " + std::to_string(device.memory_MiB) + " MiB";
    answers.devices.push_back({device.name, device.architecture});
    device.problem = tooOld(answers.devices.back(), answers.oldestArchitecture);
    list.devices.push_back(std::move(device));
  }
  if (error != cudaSuccess) {
    answers.error = cudaGetErrorString(error);
    answers.insufficientDriver = error == cudaErrorInsufficientDriver;
    answers.noDevice = error == cudaErrorNoDevice;
    cudaGetLastError();  // it has been dealt with
  }
  CudaVerdict verdict = judgeCuda(answers);
  list.cudaState = verdict.state;
  list.cudaMissing = std::move(verdict.why);
  list.driverRelease = std::move(answers.driverRelease);
  list.driverVersion = answers.driverVersion;
  list.runtimeVersion = answers.runtimeVersion;
}
#else
void addCudaDevices(DeviceList& list) {
  list.cudaState = CudaState::notBuilt;
  list.cudaMissing = "This build has no cuda device: " GW_CUDA_MISSING ".";
}
#endif

std::string threadsOn(const Processors& processors) {
  const uint32_t threads = processors.usable();
  const std::string limits = processors.limits();
  return std::to_string(threads) + (threads == 1 ? " thread" : " threads") + (limits.empty() ? "" : ": " + limits);
}

}  // namespace

DeviceList listDevices() {
  DeviceList list;
  addCudaDevices(list);
  list.processors = readProcessors();
  list.devices.push_back({"cpu", "worker pool", threadsOn(list.processors)});
  return list;
}

std::optional<int> currentCudaDevice() {
#ifdef GW_HAVE_CUDA
  int device = 0;
  if (cudaGetDevice(&device) == cudaSuccess) return device;
  cudaGetLastError();
#endif
  return std::nullopt;
}

}  // namespace gw
