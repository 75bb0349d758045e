// A game that outlives its device. It plays on the first device; when that fails, for whatever reason, it is dropped
// and the next one goes on from the last snapshot and the inputs since, to the same tick with the same bits.
//
//   ticks     ... 60 ─────────────────── 120 ───────────── x   the device fails while 171 is computed
//   kept         snapshot + inputs       snapshot + inputs
//   next device                          120 ▷▷▷▷▷▷▷▷▷▷▷▷▷▷ 171 172 ...  restored, computed again, and on
//
// Code that draws must look at onCuda() every frame: what the draw lists are written into belongs to one device.
#pragma once

#include <deque>
#include <functional>

#include "game/sim/forwarding_simulation.h"

namespace gw {

class Failover : public ForwardingSimulation {
 public:
  using Make = std::function<std::unique_ptr<Simulation>()>;

  // `next` makes the same game afresh on a device that does not fail. `tell` is called once, with one sentence.
  Failover(std::unique_ptr<Simulation> first, Make next, std::function<void(const std::string&)> tell);

  void tick(const InputRecord& input) override;
  TickReport report() override;
  Snapshot snapshot() override;
  void restore(const Snapshot& snapshot) override;
  // drawList() and particleList() throw the device's DeviceError: their targets are of no use to the next one. See
  // dropDevice().
  std::optional<EntityRecord> inspect(float x, float y, float radius_m) override;
  CandidateCount countCandidates() override;
  Census census() override;
  void enableStageTimes(bool on) override;
  bool timesStages() const override { return timed_; }
  // Throws DeviceError when there is no next one: the second failure is the last.
  void dropDevice(const std::string& why) override;
  std::string dropped() const override { return why_; }

  // Also how much work a failure costs at most: computing so many ticks again.
  static constexpr uint32_t kKeptEvery_ticks = 60;

 private:
  template <class Work>
  auto surviving(const Work& work);
  void keep();
  void readAhead();
  void forgetInputs();

  Make next_;
  std::function<void(const std::string&)> tell_;
  std::string why_;

  // What a next device would need, in ordinary memory: pinned memory dies with the device. Empty once there is none.
  std::optional<Snapshot> kept_;    // none: the start of the game
  std::vector<InputRecord> since_;  // inputs of the ticks after it
  size_t read_ = 0;                 // of those ticks, how many reports came from the device
  std::deque<TickReport> waiting_;  // reports that came before they were asked for
  bool timed_ = false;
};

}  // namespace gw
