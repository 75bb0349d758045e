#include <gpuwars/cuda_state.h>

#include <algorithm>
#include <charconv>
#include <regex>

namespace gw {

const char* nameOf(CudaState state) {
  switch (state) {
    case CudaState::ready:
      return "ready";
    case CudaState::notBuilt:
      return "notBuilt";
    case CudaState::noDriver:
      return "noDriver";
    case CudaState::driverTooOld:
      return "driverTooOld";
    case CudaState::noDevice:
      return "noDevice";
    case CudaState::deviceTooOld:
      return "deviceTooOld";
    case CudaState::failed:
      return "failed";
  }
  return "";
}

CudaVerdict judgeCuda(const CudaAnswers& answers) {
  const std::string driver = "The NVIDIA driver" + (answers.driverRelease.empty() ? "" : " " + answers.driverRelease);
  if (answers.driverVersion == 0 && !answers.error.empty()) {
    // Containers may see the driver without the library that comes with it.
    if (!answers.driverRelease.empty()) {
      return {CudaState::noDriver,
              driver + " is here, but its library libcuda.so.1 is not: install it, or let the container have the GPU."};
    }
    return {CudaState::noDriver, "There is no NVIDIA driver here: install one for CUDA " +
                                     cudaVersionText(answers.runtimeVersion) + " or newer."};
  }
  if (answers.insufficientDriver && answers.driverVersion < answers.runtimeVersion) {
    return {CudaState::driverTooOld, driver + " supports CUDA up to " + cudaVersionText(answers.driverVersion) +
                                         "; this program needs " + cudaVersionText(answers.runtimeVersion) +
                                         ": update the driver."};
  }
  if (answers.noDevice || (answers.error.empty() && answers.devices.empty())) {
    return {CudaState::noDevice, driver +
                                     " finds no GPU: see that one is plugged in, and that CUDA_VISIBLE_DEVICES "
                                     "hides none."};
  }
  if (!answers.error.empty()) {
    return {CudaState::failed, driver + " does not answer (" + answers.error +
                                   "): start the machine again, or "
                                   "reinstall the driver."};
  }
  const std::string old = tooOld(answers.devices.front(), answers.oldestArchitecture);
  if (old.empty()) return {};
  return {CudaState::deviceTooOld, old +
                                       ": build for it (CMAKE_CUDA_ARCHITECTURES), or choose another by "
                                       "CUDA_VISIBLE_DEVICES."};
}

std::string tooOld(const CudaDevice& device, int oldestArchitecture) {
  if (device.architecture >= oldestArchitecture) return "";
  return device.name + " is sm_" + std::to_string(device.architecture) + ", and this program's kernels are for sm_" +
         std::to_string(oldestArchitecture) + " and newer";
}

std::string cudaVersionText(int version) {
  return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

int oldestOf(std::string_view architectures) {
  int oldest = 0;
  while (!architectures.empty()) {
    const size_t end = std::min(architectures.find_first_of(",;"), architectures.size());
    int architecture = 0;
    std::from_chars(architectures.data(), architectures.data() + end, architecture);
    if (architecture > 0 && (oldest == 0 || architecture < oldest)) oldest = architecture;
    architectures.remove_prefix(std::min(end + 1, architectures.size()));
  }
  return oldest;
}

std::string driverReleaseIn(std::string_view text) {
  // "NVRM version: NVIDIA UNIX x86_64 Kernel Module  535.129.03  Thu Oct ...", and of the open module "NVIDIA UNIX Open
  // Kernel Module for x86_64  580.65.06  Release Build ...".
  static const std::regex release(R"(Kernel Module.*?\s(\d+\.\d+(?:\.\d+)?)\s)");
  std::match_results<std::string_view::const_iterator> match;
  return std::regex_search(text.begin(), text.end(), match, release) ? match[1].str() : "";
}

}  // namespace gw
