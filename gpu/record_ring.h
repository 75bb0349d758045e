// Small records that cross between host and device once per tick, several ticks deep. Each slot has a host side, which
// on cuda is pinned memory, and a device side; the copies between them are launches like any other, and can be
// captured.
//
//   slot           0     1     2     3         the host writes a slot of what goes to the device before it queues its
//   host side    [   ] [   ] [   ] [   ]       tick, and reads one of what comes back after a fence behind the copy:
//   device side  [   ] [   ] [   ] [   ]       until then neither side touches the other's.
#pragma once

#include <new>
#include <type_traits>

#include "gpu/buffer.h"

namespace gw::GW_DEVICE {

template <class T>
class RecordRing {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  RecordRing(Queue& queue, uint32_t slots)
      : queue_(queue), device_(queue, slots), host_(static_cast<T*>(allocateHostBytes(queue, slots * sizeof(T)))) {
    for (uint32_t s = 0; s < slots; ++s) new (host_ + s) T;
  }
  ~RecordRing() { releaseHostBytes(queue_, host_); }
  RecordRing(const RecordRing&) = delete;
  RecordRing& operator=(const RecordRing&) = delete;

  T& host(uint32_t slot) { return host_[slot]; }
  T* device() const { return device_.data(); }  // [slots]
  void toDevice(uint32_t slot) { enqueueCopy(queue_, device_.data() + slot, host_ + slot, sizeof(T), Copy::toDevice); }
  void toHost(uint32_t slot) { enqueueCopy(queue_, host_ + slot, device_.data() + slot, sizeof(T), Copy::toHost); }

 private:
  Queue& queue_;
  Buffer<T> device_;
  T* host_;
};

}  // namespace gw::GW_DEVICE
