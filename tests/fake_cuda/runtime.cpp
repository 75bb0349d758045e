// The calls of the CUDA runtime: devices, memory, errors; streams.cpp has the rest.
#include <cstdio>
#include <cstring>

#include "cuda_runtime_api.h"
#include "driver.h"

using namespace gw::stand_in;

namespace {

constexpr int kVersion = CUDART_VERSION;
constexpr size_t kShared_bytes = 48 * 1024, kSharedOptIn_bytes = 227 * 1024;

// What the direction names as device memory is device memory, all of it.
bool mayCopy(const void* to, const void* from, size_t bytes, cudaMemcpyKind kind) {
  const bool ontoDevice = kind == cudaMemcpyHostToDevice || kind == cudaMemcpyDeviceToDevice;
  const bool offDevice = kind == cudaMemcpyDeviceToHost || kind == cudaMemcpyDeviceToDevice;
  return bytes == 0 || ((!ontoDevice || isDevice(to, bytes)) && (!offDevice || isDevice(from, bytes)));
}

void copyNow(void* to, const void* from, size_t bytes) {
  std::memmove(to, from, bytes);
  if (isDevice(to, bytes)) deviceWritten(to, bytes);
}

}  // namespace

cudaError_t cudaGetLastError() {
  const std::lock_guard<std::recursive_mutex> locked(lock());
  const cudaError_t last = driver().last;
  driver().last = driver().sticky;
  return last;
}

cudaError_t cudaPeekAtLastError() {
  const std::lock_guard<std::recursive_mutex> locked(lock());
  return driver().last;
}

const char* cudaGetErrorName(cudaError_t error) {
  switch (error) {
    case cudaSuccess:
      return "cudaSuccess";
    case cudaErrorInvalidValue:
      return "cudaErrorInvalidValue";
    case cudaErrorMemoryAllocation:
      return "cudaErrorMemoryAllocation";
    case cudaErrorInsufficientDriver:
      return "cudaErrorInsufficientDriver";
    case cudaErrorNoDevice:
      return "cudaErrorNoDevice";
    case cudaErrorNoKernelImageForDevice:
      return "cudaErrorNoKernelImageForDevice";
    case cudaErrorIllegalAddress:
      return "cudaErrorIllegalAddress";
    case cudaErrorLaunchFailure:
      return "cudaErrorLaunchFailure";
    default:
      return "cudaErrorUnknown";
  }
}

const char* cudaGetErrorString(cudaError_t error) {
  switch (error) {
    case cudaSuccess:
      return "no error";
    case cudaErrorInvalidValue:
      return "invalid argument";
    case cudaErrorMemoryAllocation:
      return "out of memory";
    case cudaErrorInsufficientDriver:
      return "CUDA driver version is insufficient for CUDA runtime version";
    case cudaErrorNoDevice:
      return "no CUDA-capable device is detected";
    case cudaErrorNoKernelImageForDevice:
      return "no kernel image is available for execution on the device";
    case cudaErrorIllegalAddress:
      return "an illegal memory access was encountered";
    case cudaErrorLaunchFailure:
      return "unspecified launch failure";
    case cudaErrorStreamCaptureUnsupported:
      return "operation not permitted when stream is capturing";
    default:
      return "unknown error";
  }
}

cudaError_t cudaDriverGetVersion(int* version) {
  GW_ENTER("cudaDriverGetVersion");
  *version = kVersion;
  return cudaSuccess;
}

cudaError_t cudaRuntimeGetVersion(int* version) {
  GW_ENTER("cudaRuntimeGetVersion");
  *version = kVersion;
  return cudaSuccess;
}

cudaError_t cudaGetDeviceCount(int* count) {
  GW_ENTER("cudaGetDeviceCount");
  *count = 1;
  return cudaSuccess;
}

cudaError_t cudaGetDevice(int* device) {
  GW_ENTER("cudaGetDevice");
  *device = 0;
  return cudaSuccess;
}

cudaError_t cudaSetDevice(int device) {
  GW_ENTER("cudaSetDevice");
  return device == 0 ? cudaSuccess : failed(cudaErrorInvalidDevice);
}

cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int device) {
  GW_ENTER("cudaGetDeviceProperties");
  if (device != 0) return failed(cudaErrorInvalidDevice);
  *properties = cudaDeviceProp{};
  std::snprintf(properties->name, sizeof properties->name, "%s", kDeviceName);
  properties->totalGlobalMem = size_t(4) << 30;
  properties->sharedMemPerBlock = kShared_bytes;
  properties->sharedMemPerBlockOptin = kSharedOptIn_bytes;
  properties->major = deviceArchitecture() / 10;
  properties->minor = deviceArchitecture() % 10;
  properties->multiProcessorCount = 1;
  return cudaSuccess;
}

cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int device) {
  GW_ENTER("cudaDeviceGetAttribute");
  if (device != 0) return failed(cudaErrorInvalidDevice);
  switch (attribute) {
    case cudaDevAttrMaxThreadsPerBlock:
      *value = 1024;
      return cudaSuccess;
    case cudaDevAttrMaxSharedMemoryPerBlock:
      *value = int(kShared_bytes);
      return cudaSuccess;
    case cudaDevAttrMaxSharedMemoryPerBlockOptin:
      *value = int(kSharedOptIn_bytes);
      return cudaSuccess;
    case cudaDevAttrMultiProcessorCount:
      *value = 1;
      return cudaSuccess;
    case cudaDevAttrComputeCapabilityMajor:
      *value = deviceArchitecture() / 10;
      return cudaSuccess;
    case cudaDevAttrComputeCapabilityMinor:
      *value = deviceArchitecture() % 10;
      return cudaSuccess;
    default:
      return failed(cudaErrorInvalidValue);
  }
}

cudaError_t cudaDeviceSynchronize() {
  GW_ENTER_OUTSIDE_CAPTURE("cudaDeviceSynchronize");
  finishAll();
  return outcomeOfWork();
}

cudaError_t cudaMemGetInfo(size_t* free, size_t* total) {
  GW_ENTER("cudaMemGetInfo");
  *free = *total = size_t(4) << 30;
  return cudaSuccess;
}

cudaError_t cudaMalloc(void** pointer, size_t bytes) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaMalloc");
  *pointer = bytes ? allocateDevice(bytes) : nullptr;
  return *pointer || !bytes ? cudaSuccess : failed(cudaErrorMemoryAllocation);
}

cudaError_t cudaMallocHost(void** pointer, size_t bytes) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaMallocHost");
  *pointer = allocateGuarded(bytes ? bytes : 1, true);
  return *pointer ? cudaSuccess : failed(cudaErrorMemoryAllocation);
}

cudaError_t cudaHostAlloc(void** pointer, size_t bytes, unsigned) {
  return cudaMallocHost(pointer, bytes);
}

cudaError_t cudaFree(void* pointer) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaFree");
  finishAll();  // it waits for the device
  return pointer == nullptr || releaseDevice(pointer) ? cudaSuccess : failed(cudaErrorInvalidValue);
}

cudaError_t cudaFreeHost(void* pointer) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaFreeHost");
  finishAll();
  return pointer == nullptr || releaseGuarded(pointer, true) ? cudaSuccess : failed(cudaErrorInvalidValue);
}

cudaError_t cudaMemcpyAsync(void* to, const void* from, size_t bytes, cudaMemcpyKind kind, cudaStream_t stream) {
  GW_ENTER("cudaMemcpyAsync");
  CUstream_st* on = streamOf(stream);
  if (!on) return failed(cudaErrorInvalidResourceHandle);
  if (!mayCopy(to, from, bytes, kind)) return failed(cudaErrorInvalidValue);
  if (kind == cudaMemcpyHostToDevice && !isPinned(from)) {
    // Ordinary memory has been read when the call returns; while a stream is captured it must not be used at all.
    if (on->captured) return failed(cudaErrorStreamCaptureUnsupported);
    const auto* begin = static_cast<const unsigned char*>(from);
    enqueue(*on, [to, staged = std::vector<unsigned char>(begin, begin + bytes)] {
      copyNow(to, staged.data(), staged.size());
    });
    return cudaSuccess;
  }
  const bool waits = kind == cudaMemcpyDeviceToHost && !isPinned(to);
  if (waits && on->captured) return failed(cudaErrorStreamCaptureUnsupported);
  enqueue(*on, [to, from, bytes] { copyNow(to, from, bytes); });
  if (!waits) return cudaSuccess;
  finish(*on);
  return outcomeOfWork();
}

cudaError_t cudaMemcpy(void* to, const void* from, size_t bytes, cudaMemcpyKind kind) {
  GW_ENTER_OUTSIDE_CAPTURE("cudaMemcpy");
  if (!mayCopy(to, from, bytes, kind)) return failed(cudaErrorInvalidValue);
  finish(driver().defaultStream);  // streams that do not block it are not waited for
  copyNow(to, from, bytes);
  return outcomeOfWork();
}

cudaError_t cudaMemsetAsync(void* to, int value, size_t bytes, cudaStream_t stream) {
  GW_ENTER("cudaMemsetAsync");
  CUstream_st* on = streamOf(stream);
  if (!on) return failed(cudaErrorInvalidResourceHandle);
  if (bytes > 0 && !isDevice(to, bytes) && !isPinned(to)) return failed(cudaErrorInvalidValue);
  enqueue(*on, [to, value, bytes] {
    std::memset(to, value, bytes);
    deviceWritten(to, bytes);
  });
  return cudaSuccess;
}
