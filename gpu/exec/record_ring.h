// Small records that cross between host and device once per tick, several ticks deep. The host has a slot for each tick
// in flight, on cuda in pinned memory; the device has one record, since its ticks run one after the other. The copies
// between them are work of the queue like any other, and can be captured.
//
//   host     [   ] [   ] [   ] [   ]     Of what goes to the device the host writes a slot before it queues its tick;
//   of
//                  \   |   /             what comes back it reads one after a fence behind the copy. Until then neither
//   device           [   ]               side touches the other's.
#pragma once

#include <gpuwars/exec.h>

#include <new>
#include <type_traits>

namespace gw::GW_DEVICE {

// Its queue outlives it, and no copy of it may be in flight when it ends.
template <class T>
class RecordRing {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  // Throws DeviceOutOfMemory on cuda, std::bad_alloc on cpu.
  RecordRing(Queue& queue, uint32_t slots)
      : queue_(queue), host_(static_cast<T*>(allocateHostBytes(queue, slots * sizeof(T)))) {
    for (uint32_t s = 0; s < slots; ++s) new (host_ + s) T;
  }
  ~RecordRing() { releaseHostBytes(queue_, host_); }
  RecordRing(const RecordRing&) = delete;
  RecordRing& operator=(const RecordRing&) = delete;

  // The host's slot; which one is not checked.
  T& host(uint32_t slot) { return host_[slot]; }
  // Queues the copy of a slot to the device.
  void toDevice(uint32_t slot, T* d_record) { enqueueCopy(queue_, d_record, host_ + slot, sizeof(T), Copy::toDevice); }
  // Queues the copy of the device's record into a slot.
  void toHost(uint32_t slot, const T* d_record) {
    enqueueCopy(queue_, host_ + slot, d_record, sizeof(T), Copy::toHost);
  }

 private:
  Queue& queue_;
  T* host_;
};

}  // namespace gw::GW_DEVICE
