// Memory that belongs to a device.
#pragma once

#include <gpuwars/exec.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace gw::GW_DEVICE {

// Owns `count` elements of device memory: move-only, zeroed when made, never resized. Its queue outlives it, and no
// launch that uses it may still be in flight when it ends. An empty one (made without a queue, or moved from) has size
// 0 and no address.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  // Throws DeviceOutOfMemory on cuda, std::runtime_error on cpu, when there is no room.
  Buffer(Queue& queue, size_t count)
      : queue_(&queue), data_(static_cast<T*>(allocateBytes(queue, count * sizeof(T)))), count_(count) {
    queue.bytes += count * sizeof(T);
  }
  ~Buffer() {
    if (!data_) return;
    queue_->bytes -= count_ * sizeof(T);
    releaseBytes(*queue_, data_);
  }
  // Takes the memory; `other` is empty then.
  Buffer(Buffer&& other) noexcept { swap(other); }
  // Exchanges the memory: what this one had ends with `other`.
  Buffer& operator=(Buffer&& other) noexcept {
    swap(other);
    return *this;
  }

  T* data() const { return data_; }       // a device address: only kernels and copies may follow it
  size_t size() const { return count_; }  // elements

  // Copies count elements from the host to offset; a pinned source must stay until the queue has passed, any other has
  // been read. Does not check bounds: offset + count is at most size().
  void upload(const T* source, size_t count, size_t offset = 0) {
    copyBytes(*queue_, data_ + offset, source, count * sizeof(T), Copy::toDevice);
  }
  // All of a vector, to the beginning.
  void upload(const std::vector<T>& source) { upload(source.data(), source.size()); }

  // Waits for the queue, then copies. Throws DeviceError on cuda when what it waited for has failed.
  void download(T* destination, size_t count, size_t offset = 0) const {
    copyBytes(*queue_, destination, data_ + offset, count * sizeof(T), Copy::toHost);
  }
  // All of it.
  std::vector<T> download() const {
    std::vector<T> copy(count_);
    download(copy.data(), count_);
    return copy;
  }

 private:
  void swap(Buffer& other) noexcept {
    std::swap(queue_, other.queue_);
    std::swap(data_, other.data_);
    std::swap(count_, other.count_);
  }

  Queue* queue_ = nullptr;
  T* data_ = nullptr;
  size_t count_ = 0;
};

}  // namespace gw::GW_DEVICE
