// The simulation of one device: queues ticks, reads reports, takes and restores snapshots.
#include <array>
#include <cstring>
#include <stdexcept>

#include "game/sim/debug/inspection.h"
#include "game/sim/debug/state_columns.h"
#include "game/sim/draw/draw_list.h"
#include "game/sim/draw/particle_list.h"
#include "game/sim/queries/candidates.h"
#include "game/sim/queries/census.h"
#include "game/sim/simulation.h"
#include "game/sim/snapshot.h"
#include "game/sim/step.h"
#include "gpu/exec/record_ring.h"
#include "gpu/exec/tick_graph.h"

namespace gw::GW_DEVICE {
namespace {

#if GW_ON_CUDA
std::string nameOf(const Queue&) {
  int device = 0;
  cudaDeviceProp properties{};
  check(cudaGetDevice(&device), "asking for the device");
  check(cudaGetDeviceProperties(&properties, device), "asking for the device's name");
  return std::string("cuda, ") + properties.name;
}
#else
std::string nameOf(const Queue& queue) {
  return "cpu, " + std::to_string(queue.pool.threads()) + (queue.pool.threads() == 1 ? " thread" : " threads");
}
#endif

class DeviceSimulation final : public Simulation, private Inspection {
 public:
  explicit DeviceSimulation(const SimulationConfig& config)
      : queue_({config.threads, config.order, config.protectMemory, config.blockSize, config.checkLaunches}),
        state_(queue_, config),
        facts_{config,         state_.limits().capacity, state_.limits().width_m, state_.limits().height_m,
               nameOf(queue_), GW_ON_CUDA != 0},
        config_(facts_.config),
        inputs_(queue_, kTicksInFlight),
        reports_(queue_, kTicksInFlight),
        drawList_(queue_, state_.limits().capacity),
        candidates_(queue_, state_.limits().capacity),
        census_(queue_) {
    if (config_.particles) {
      particles_ = Particles(queue_, state_.limits().capacity);
      particleList_ = ParticleList(queue_, kParticleRing);
    }
    capture(plain_);
    queue_.synchronise();  // the first tick is as fast as any
  }

  void tick(const InputRecord& input) override {
    if (launched_ - read_ >= kTicksInFlight) {
      throw std::logic_error("Too many ticks are queued: read a report first.");
    }
    const uint32_t slot = launched_ % kTicksInFlight;
    inputs_.host(slot) = input;  // its last reader's report has been read
    const bool sortInFull = wantsFullSort();
    Captured& captured = (timer_.enabled() ? timed_ : plain_)[sortInFull][slot];
    captured.graph.replay(queue_);
    launchesPerTick_ = captured.launches;
    fences_[slot].place(queue_);
    marks_[slot] = &captured.marks;
    ++launched_;
    if (sortInFull) {
      rowsWidened_ = 0.0f;
      sorted_ = launched_;
    }
  }

  TickReport report() override {
    if (read_ == launched_) throw std::logic_error("No tick is queued: there is nothing to report.");
    const uint32_t slot = read_ % kTicksInFlight;
    fences_[slot].wait();
    const TickReport report = reports_.host(slot);
    timer_.collect(*marks_[slot]);
    ++read_;
    if (read_ > sorted_) rowsWidened_ = report.rowsWidened;  // earlier ones are from before the last full sort
    return report;
  }

  Snapshot snapshot() override { return takeSnapshot(state_, next()); }

  void restore(const Snapshot& snapshot) override {
    restoreSnapshot(queue_, state_, next(), snapshot);
    rowsWidened_ = 0.0f;  // what reports of earlier ticks say is of rows that are gone
    sorted_ = launched_;
    if (config_.particles) particles_.clear();  // they are no state: what flew belongs to another run
  }

  void drawList(const DrawView& view, const DrawTarget& target) override {
    drawList_.run(queue_, next(), view, target);
    queue_.synchronise();  // its next reader is on no queue of ours
  }

  void particleList(const DrawView& view, float sinceTick_ticks, const ParticleTarget& target) override {
    if (!config_.particles) return;
    particleList_.run(queue_, next(), particles_.view(launched_), view, sinceTick_ticks, target);
    queue_.synchronise();
  }

  std::vector<Particle> particles() const override {
    return config_.particles ? particles_.list(launched_) : std::vector<Particle>();
  }

  std::optional<EntityRecord> inspect(float x, float y, float radius_m) override {
    std::optional<EntityRecord> nearest;
    float best2 = radius_m * radius_m;
    for (const EntityRecord& e : snapshot().entities) {
      const float dx = e.x - x, dy = e.y - y, d2 = dx * dx + dy * dy;
      if (!isEnemy(e.type) || e.state == uint32_t(State::dead) || d2 > best2) continue;
      if (d2 == best2 && nearest) continue;  // the lower id came first
      best2 = d2;
      nearest = e;
    }
    return nearest;
  }

  CandidateCount countCandidates() override { return candidates_.run(queue_, next()); }

  Census census() override { return census_.run(queue_, next(), state_.neighbourhood()); }

  void enableStageTimes(bool on) override {
    timer_.enable(on);
    if (on && !timedCaptured_) {
      capture(timed_);
      timedCaptured_ = true;
    }
  }

  bool timesStages() const override { return timer_.enabled(); }

  std::vector<StageTime> stageTimes() const override {
    std::vector<StageTime> times;
    for (const auto& stage : timer_.stages()) times.push_back({stage.name, stage.total_ms, stage.calls});
    return times;
  }

  Inspection& inspection() override { return *this; }

  uint32_t launchesPerTick() const override { return launchesPerTick_; }
  size_t deviceBytes() const override { return queue_.bytes; }
  const SimulationFacts& facts() const override { return facts_; }

#if GW_ON_CUDA
  void park() override {}
#else
  void park() override {
    queue_.pool.park();
  }
#endif

 private:
  TickReport tickByStages(const InputRecord& input, const AfterStage& after) override {
    if (read_ != launched_) throw std::logic_error("Ticks are queued: read their reports first.");
    const uint32_t slot = launched_ % kTicksInFlight;
    inputs_.host(slot) = input;
    {
      struct Telling {
        DeviceSimulation& of;
        ~Telling() {
          of.timer_.tell(nullptr);
          of.inStages_ = false;
        }
      } telling{*this};
      inStages_ = true;
      timer_.tell([&](const char* stage) { after(stage); });
      runTick(slot, wantsFullSort());
    }
    queue_.synchronise();
    ++launched_;
    ++read_;
    const TickReport report = reports_.host(slot);
    rowsWidened_ = report.rowsWidened;
    return report;
  }

  StageState stateAfter(const std::string& stage, const StageState* before) override {
    return readState(state_, running(), stage, before);
  }

  std::vector<BytesOfBuffer> bytes() override {
    return bytesOf(queue_, state_, running());
  }

  void flip(const BytesOfBuffer& part, uint32_t element, uint32_t bit) override {
    uint8_t* d_byte = part.d_bytes + size_t(element) * part.stride + bit / 8;
    uint8_t byte = 0;
    copyBytes(queue_, &byte, d_byte, 1, Copy::toHost);
    byte ^= uint8_t(1u << bit % 8);
    copyBytes(queue_, d_byte, &byte, 1, Copy::toDevice);
    queue_.synchronise();
  }

  // Of the tick by stages that runs, or of the last tick.
  View running() const {
    return state_.view((launched_ + (inStages_ ? 0 : 1)) % 2);
  }

  bool wantsFullSort() const {
    return rowsWidened_ > kWorthRebuilding && frozenRows();
  }
  bool frozenRows() const {
    return config_.broadPhase == BroadPhase::ngrid && config_.sortInUse() == Sort::frozen;
  }

  // A graph for each slot of the rings, and so for each parity too, with and without a full sort of frozen rows.
  struct Captured {
    TickGraph graph;
    StageMarks marks;
    uint32_t launches = 0;
  };
  using CapturedTicks = std::array<std::array<Captured, kTicksInFlight>, 2>;

  void capture(CapturedTicks& ticks) {
    for (const bool sortInFull : {false, true}) {
      if (sortInFull && !frozenRows()) continue;
      for (uint32_t slot = 0; slot < kTicksInFlight; ++slot) {
        Captured& captured = ticks[sortInFull][slot];
        timer_.captureInto(captured.marks);
        captured.graph =
            TickGraph(queue_, [this, &captured, slot, sortInFull] { captured.launches = runTick(slot, sortInFull); });
      }
    }
  }

  // How many launches it took.
  uint32_t runTick(uint32_t slot, bool sortInFull) {
    const uint64_t before = queue_.launches;
    TickScratch* d_scratch = state_.scratch.data();
    inputs_.toDevice(slot, &d_scratch->input);
    state_.neighbourhood().sortInFull(sortInFull);
    step(queue_, state_, slot % 2, config_.autopilot, timer_, config_.particles ? &particles_ : nullptr);
    reports_.toHost(slot, state_.report.data());
    return uint32_t(queue_.launches - before);
  }

  // What the next tick will see: its cells are where the last tick ended.
  View next() const {
    return state_.view(launched_ % 2);
  }

  Queue queue_;
  GameState state_;
  const SimulationFacts facts_;
  const SimulationConfig& config_;
  RecordRing<InputRecord> inputs_;
  RecordRing<TickReport> reports_;
  StageTimer timer_;
  DrawList drawList_;
  Particles particles_;
  ParticleList particleList_;
  Candidates candidates_;
  CensusTaker census_;
  CapturedTicks plain_, timed_;
  bool timedCaptured_ = false;
  std::array<Fence, kTicksInFlight> fences_;
  std::array<const StageMarks*, kTicksInFlight> marks_{};
  uint32_t launchesPerTick_ = 0;
  uint32_t launched_ = 0, read_ = 0;
  bool inStages_ = false;
  // Frozen rows are sorted in full when a report says that they have widened: how to compute a tick is the host's to
  // choose, since it changes no bit of it.
  uint32_t sorted_ = 0;  // ticks launched when they were sorted last
  float rowsWidened_ = 0.0f;
};

}  // namespace

std::unique_ptr<Simulation> makeSimulation(const SimulationConfig& config) {
  return std::make_unique<DeviceSimulation>(config);
}

}  // namespace gw::GW_DEVICE
