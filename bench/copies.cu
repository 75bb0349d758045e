#include <algorithm>

#include "bench/copies.h"
#include "gpu/exec/buffer.h"
#include "host/platform/clock.h"

namespace gw::GW_DEVICE {
namespace {

// Host memory from which the device copies at full speed.
class HostBytes {
 public:
  HostBytes(Queue& queue, size_t bytes)
      : queue_(queue), h_data_(static_cast<unsigned char*>(allocateHostBytes(queue, bytes))) {
    std::fill_n(h_data_, bytes, static_cast<unsigned char>(1));  // untouched pages are not mapped yet
  }
  ~HostBytes() { releaseHostBytes(queue_, h_data_); }
  HostBytes(const HostBytes&) = delete;
  HostBytes& operator=(const HostBytes&) = delete;
  unsigned char* data() const { return h_data_; }

 private:
  Queue& queue_;
  unsigned char* h_data_;
};

// The best of the rounds: what the machine can do when nothing disturbs it.
template <class CopyOnce>
double gigabytesPerSecond(Queue& queue, size_t bytes, unsigned rounds, const CopyOnce& copyOnce) {
  double best_s = 1e9;
  for (unsigned round = 0; round < rounds; ++round) {
    const double begin_s = now_s();
    copyOnce();
    queue.synchronise();
    best_s = std::min(best_s, now_s() - begin_s);
  }
  return double(bytes) / best_s * 1e-9;
}

}  // namespace

bench::CopySpeeds copySpeeds(const ExecOptions& options, size_t bytes, unsigned rounds) {
  Queue queue(options);
  const HostBytes host(queue, bytes);
  Buffer<unsigned char> one(queue, bytes), other(queue, bytes);
  queue.synchronise();
  const auto measure = [&](const auto& copyOnce) { return gigabytesPerSecond(queue, bytes, rounds, copyOnce); };
  bench::CopySpeeds speeds;
  speeds.toDevice = measure([&] { one.upload(host.data(), bytes); });
  speeds.toHost = measure([&] { one.download(host.data(), bytes); });
  speeds.onDevice = measure([&] { copyBytes(queue, other.data(), one.data(), bytes, Copy::onDevice); });
  return speeds;
}

}  // namespace gw::GW_DEVICE
