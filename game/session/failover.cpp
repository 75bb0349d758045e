#include "game/session/failover.h"

#include <utility>

#include "gpu/devices/device_error.h"

namespace gw {

Failover::Failover(std::unique_ptr<Simulation> first, Make next, std::function<void(const std::string&)> tell)
    : ForwardingSimulation(std::move(first)), next_(std::move(next)), tell_(std::move(tell)) {}

// What work() did on the device that failed it does again on the next one.
template <class Work>
auto Failover::surviving(const Work& work) {
  try {
    return work();
  } catch (const DeviceError& error) {
    dropDevice(error.what());
    return work();
  }
}

void Failover::dropDevice(const std::string& why) {
  if (!next_) throw DeviceError(why);
  const Make make = std::exchange(next_, nullptr);
  why_ = why;
  tell_(why);
  device_.reset();  // first: the next one may need its memory
  device_ = make();
  if (kept_) device_->restore(*kept_);
  for (size_t t = 0; t < since_.size(); ++t) {
    device_->tick(since_[t]);
    if (t < read_) device_->report();
  }
  if (timed_) device_->enableStageTimes(true);
  kept_.reset();
  forgetInputs();
}

void Failover::forgetInputs() {
  since_.clear();
  read_ = 0;
}

// So that the device owes nothing for the inputs before a snapshot.
void Failover::readAhead() {
  for (; read_ < since_.size(); ++read_) waiting_.push_back(device_->report());
}

void Failover::keep() {
  if (!next_) return;
  readAhead();
  kept_ = device_->snapshot();
  forgetInputs();
}

void Failover::tick(const InputRecord& input) {
  if (since_.size() >= kKeptEvery_ticks) surviving([&] { keep(); });
  if (next_) since_.push_back(input);
  try {
    device_->tick(input);
  } catch (const DeviceError& error) {
    dropDevice(error.what());  // which computes this tick too
  }
}

TickReport Failover::report() {
  if (!waiting_.empty()) {
    const TickReport early = waiting_.front();
    waiting_.pop_front();
    return early;
  }
  const TickReport report = surviving([&] { return device_->report(); });
  if (next_) ++read_;
  return report;
}

Snapshot Failover::snapshot() {
  return surviving([&] { return device_->snapshot(); });
}

void Failover::restore(const Snapshot& snapshot) {
  surviving([&] {
    readAhead();
    device_->restore(snapshot);
  });
  if (!next_) return;
  kept_ = snapshot;
  forgetInputs();
}

std::optional<EntityRecord> Failover::inspect(float x, float y, float radius_m) {
  return surviving([&] { return device_->inspect(x, y, radius_m); });
}

CandidateCount Failover::countCandidates() {
  return surviving([&] { return device_->countCandidates(); });
}

Census Failover::census() {
  return surviving([&] { return device_->census(); });
}

void Failover::enableStageTimes(bool on) {
  timed_ = on;
  surviving([&] { device_->enableStageTimes(on); });
}

}  // namespace gw
