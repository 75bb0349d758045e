#include "driver.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace gw::stand_in {
namespace {

constexpr unsigned char kLost = 0xDB;

[[noreturn]] void refuseOption(const std::string& option) {
  std::fprintf(stderr, "%s: '%s' is not known; %s lists what is.\n", kOptionsVariable, option.c_str(), kOptionsHelp);
  std::exit(2);
}

Fault faultFrom(const std::string& option) {
  Fault fault;
  std::istringstream text(option.substr(6));
  std::string number, error;
  if (!std::getline(text, fault.call, ':') || !std::getline(text, number, ':') || !std::getline(text, error)) {
    refuseOption(option);
  }
  fault.number = std::strtoull(number.c_str(), nullptr, 10);
  fault.error = cudaError_t(std::atoi(error.c_str()));
  return fault;
}

// After these the context is dead: CUDA's documentation says so of each.
bool isSticky(cudaError_t error) {
  switch (error) {
    case cudaErrorECCUncorrectable:
    case cudaErrorIllegalAddress:
    case cudaErrorLaunchTimeout:
    case cudaErrorLaunchFailure:
    case cudaErrorUnknown:
      return true;
    default:
      return false;
  }
}

size_t inPages(size_t bytes) {
  const size_t page = size_t(sysconf(_SC_PAGESIZE));
  return (bytes + page - 1) / page * page;
}

}  // namespace

Options optionsFromEnvironment() {
  Options options;
  const char* given = std::getenv(kOptionsVariable);
  std::istringstream text(given ? given : "");
  for (std::string option; std::getline(text, option, ',');) {
    if (option == "eager") {
      options.eager = true;
    } else if (option == "apart") {
      options.apart = true;
    } else if (option.starts_with("fault=")) {
      options.fault = faultFrom(option);
    } else if (!option.empty() && !takeDeviceOption(options, option)) {
      refuseOption(option);
    }
  }
  return options;
}

thread_local unsigned capturing = 0;

std::recursive_mutex& lock() {
  static std::recursive_mutex mutex;
  return mutex;
}

Driver& driver() {
  static Driver* driver = [] {
    auto* made = new Driver;  // never destroyed: destructors of others may still call
    made->options = optionsFromEnvironment();
    return made;
  }();
  return *driver;
}

void restart(const Options& options) {
  const std::lock_guard<std::recursive_mutex> locked(lock());
  Driver& d = driver();
  for (auto& [address, block] : d.blocks) munmap(block.mapped, block.mapped_bytes);
  for (CUstream_st* stream : d.streams) delete stream;
  for (CUevent_st* event : d.events) delete event;
  restartDevice();
  Driver fresh;
  fresh.options = options;
  d = std::move(fresh);
  capturing = 0;
}

cudaError_t failed(cudaError_t error) {
  driver().last = error;
  return error;
}

cudaError_t entering(const char* call) {
  Driver& d = driver();
  ++d.calls;
  d.log.push_back(call);
  const uint64_t byName = ++d.byName[call];
  if (d.sticky != cudaSuccess) return failed(d.sticky);
  const Fault& fault = d.options.fault;
  const bool any = fault.call == "*";
  if (fault.number == 0 || !(any || fault.call == call) || (any ? d.calls : byName) != fault.number) return cudaSuccess;
  d.struck = call;
  if (isSticky(fault.error)) deviceFailed(fault.error);
  return failed(fault.error);
}

cudaError_t enteringOutsideCapture(const char* call) {
  const cudaError_t error = entering(call);
  if (error != cudaSuccess) return error;
  return capturing > 0 ? failed(cudaErrorStreamCaptureUnsupported) : cudaSuccess;
}

CUstream_st* streamOf(cudaStream_t stream) {
  Driver& d = driver();
  if (stream == nullptr) return &d.defaultStream;
  return d.streams.count(stream) ? stream : nullptr;
}

void enqueue(CUstream_st& stream, Work work) {
  if (stream.captured) {
    stream.captured->nodes.push_back(std::move(work));
    return;
  }
  stream.queued.push_back(std::move(work));
  ++stream.enqueued;
  if (driver().options.eager) finish(stream);
}

void finishUpTo(CUstream_st& stream, uint64_t work) {
  while (stream.done < work && !stream.queued.empty()) {
    const Work next = std::move(stream.queued.front());
    stream.queued.pop_front();
    next();
    ++stream.done;
  }
}

void finish(CUstream_st& stream) {
  finishUpTo(stream, stream.enqueued);
}

void finishAll() {
  finish(driver().defaultStream);
  for (CUstream_st* stream : driver().streams) finish(*stream);
}

// So that it ends where the next page begins, which is not to be touched.
void* allocateGuarded(size_t bytes, bool pinned) {
  const size_t room = inPages(bytes), mapped_bytes = room + inPages(1);
  void* mapped = mmap(nullptr, mapped_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) return nullptr;
  mprotect(static_cast<char*>(mapped) + room, inPages(1), PROT_NONE);
  char* begin = static_cast<char*>(mapped) + (room - (bytes + 15) / 16 * 16);
  std::memset(begin, kNeverWritten, bytes);
  driver().blocks[uintptr_t(begin)] = {mapped, mapped_bytes, bytes, pinned};
  if (pinned) pinnedAllocated(begin, bytes);
  return begin;
}

bool releaseGuarded(void* pointer, bool pinned) {
  auto& blocks = driver().blocks;
  const auto found = blocks.find(uintptr_t(pointer));
  if (found == blocks.end() || found->second.pinned != pinned) return false;
  if (pinned) pinnedReleased(pointer);
  munmap(found->second.mapped, found->second.mapped_bytes);
  blocks.erase(found);
  return true;
}

const Block* guardedBlock(const void* pointer) {
  const auto& blocks = driver().blocks;
  auto after = blocks.upper_bound(uintptr_t(pointer));
  if (after == blocks.begin()) return nullptr;
  --after;
  return uintptr_t(pointer) < after->first + after->second.bytes ? &after->second : nullptr;
}

bool isPinned(const void* pointer) {
  const Block* block = guardedBlock(pointer);
  return block && block->pinned;
}

void deviceFailed(cudaError_t error) {
  driver().sticky = error;
  loseMemory();
}

cudaError_t outcomeOfWork() {
  return driver().sticky == cudaSuccess ? cudaSuccess : failed(driver().sticky);
}

void loseMemory() {
  for (auto& [address, block] : driver().blocks) std::memset(reinterpret_cast<void*>(address), kLost, block.bytes);
  driver().defaultStream.queued.clear();
  for (CUstream_st* stream : driver().streams) stream->queued.clear();
}

size_t dynamicSharedLimit_bytes(const void* kernel) {
  const auto granted = driver().sharedLimits.find(kernel);
  return granted == driver().sharedLimits.end() ? 48 * 1024 : size_t(granted->second);
}

uint64_t calls() {
  return driver().calls;
}
const std::map<std::string, uint64_t>& callsByName() {
  return driver().byName;
}
const std::vector<std::string>& callLog() {
  return driver().log;
}
std::string struck() {
  return driver().struck;
}
uint64_t kernelsRun() {
  return driver().kernels;
}

}  // namespace gw::stand_in
