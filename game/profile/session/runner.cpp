#include "game/profile/session/runner.h"

#include <fmt/format.h>

#include <cmath>
#include <deque>

#include "game/session/fixed_timestep.h"
#include "host/platform/clock.h"

namespace gw::profile {
namespace {

constexpr uint32_t kCountEvery_ticks = 60;  // candidates: a search of all enemies for nothing else

// One frame of every 32, at another place in each: much of a game goes in beats of two and four ticks, so a fixed place
// would see the same beat for ever.
bool isSample(uint64_t frame) {
  constexpr uint64_t kEvery = 32, kOdd = 0x9E3779B97F4A7C15;
  return frame % kEvery == ((frame / kEvery + 1) * kOdd) >> 59;
}

// Times of the stages, tick by tick, out of the simulation's totals. On cuda a staged tick is a graph of its own, with
// events between the stages: the samples, whose totals are then not the game's alone. On the cpu a steady clock costs
// next to nothing: all but the samples, by which its cost is told. The second frame's are timed on both, so that a
// short run has some.
class StageTimes {
 public:
  explicit StageTimes(Simulation& simulation) : simulation_(simulation) {
    simulation_.enableStageTimes(true);  // what that takes the first time is not a frame's
    simulation_.enableStageTimes(false);
  }

  void begin(uint64_t frame) {
    staged_ = frame == 1 || isSample(frame) == simulation_.onCuda();
    simulation_.enableStageTimes(staged_);
  }
  void beginAlways() { simulation_.enableStageTimes(staged_ = true); }

  // What each of the ticks since begin() took, which share their time evenly.
  void end(Frame& frame, std::vector<std::string>& names) {
    frame.staged = staged_ && frame.ticks > 0;
    if (!frame.staged) return;
    frame.disturbed = simulation_.onCuda();
    const std::vector<StageTime> now = simulation_.stageTimes();
    frame.stages_ms.resize(now.size());
    before_.resize(now.size());
    for (size_t i = 0; i < now.size(); ++i) {
      frame.stages_ms[i] = float((now[i].total_ms - before_[i]) / frame.ticks);
      before_[i] = now[i].total_ms;
    }
    if (names.size() == now.size()) return;
    names.clear();
    for (const StageTime& stage : now) names.push_back(stage.name);
  }

 private:
  Simulation& simulation_;
  std::vector<double> before_;  // totals, when the last staged tick was over
  bool staged_ = false;
};

// Between two frames, once in kCountEvery_ticks: all enemies search, for nothing but counting.
class Counting {
 public:
  explicit Counting(Simulation& simulation) : simulation_(simulation) {}

  void after(Frame& frame) {
    const uint32_t turn = frame.tick / kCountEvery_ticks;
    if (turn == turn_) return;
    turn_ = turn;
    const CandidateCount count = simulation_.countCandidates();
    frame.gather_ms = count.search_ms;
    frame.candidates = double(count.tested);
    frame.neighbours = double(count.found);
    frame.searching = double(count.entities);
  }

 private:
  Simulation& simulation_;
  uint32_t turn_ = 0;
};

// What OpenGL tells of frames, some frames later.
class LateTimes {
 public:
  explicit LateTimes(Picture* picture) : picture_(picture) {}

  void expect(size_t frame) { frames_.push_back(frame); }
  void takeInto(std::vector<Frame>& frames) {
    while (!frames_.empty()) {
      const std::optional<double> took_ms = picture_->takeGlTime_ms(false);
      if (!took_ms) return;
      frames[frames_.front()].gl_ms = *took_ms;
      frames_.pop_front();
    }
  }

 private:
  Picture* picture_;
  std::deque<size_t> frames_;  // by number
};

// Takes time that is not the game's: no tick comes due by it.
template <class Work>
void outsideOfPlay(FixedTimestep& timestep, const Work& work) {
  timestep.frame(now_ms() / 1000);
  work();
  timestep.pause();
  timestep.frame(now_ms() / 1000);
  timestep.resume();
}

void tell(Frame& frame, const TickReport& report, const RunPlan& plan) {
  frame.tick = report.tick;
  frame.live = report.enemies;
  frame.inView = report.enemiesInView;
  frame.kills = report.kills;
  frame.warmUp = report.tick <= plan.warmUp_ticks;
}

}  // namespace

PlayedRun Runner::play(const ContenderChoice& contender, const RunPlan& plan, const Listener& listener) {
  const SimulationConfig config = configOf(contender);
  contender_ = contender.name;
  return contender.shadow() ? playShadow(config, plan, listener) : playExact(config, plan, listener);
}

SimulationConfig Runner::configOf(const ContenderChoice& contender) const {
  SimulationConfig config = config_;
  config.broadPhase = contender.broadPhase;
  config.gather = contender.gather;
  config.sort = contender.sort;
  config.particles = picture_ != nullptr && picture_->showsEffects();
  return config;
}

void Runner::check(const TickReport& report) const {
  const uint64_t recorded = scene_.replay.hashes.at(report.tick - 1);
  if (report.hash == recorded) return;
  throw SceneDesync(
      fmt::format("{}, played by {}, differs from its recording from tick {} on, so its times compare nothing: find "
                  "out more with 'gpuwars verify'.",
                  scene_.name, contender_, report.tick));
}

// What a run was recorded with, one tick on.
void Runner::tick(Run& run) const {
  const uint32_t next = run.last().tick;
  if (!run.tick(scene_.replay.inputs[next])) {
    throw SceneDesync(fmt::format("{} is over after {} ticks, and its recording goes on: cut it with 'gpuwars trim'.",
                                  scene_.name, next));
  }
  check(run.last());
}

PlayedRun Runner::playExact(const SimulationConfig& config, const RunPlan& plan, const Listener& listener) {
  PlayedRun played;
  RunFrames& out = played.frames;
  out.drawn = picture_ != nullptr;
  double start = now_ms();
  Run run(make_(config), std::nullopt);
  if (picture_) picture_->begin(run);
  const double made = now_ms();
  StageTimes stages(run.simulation());
  start += now_ms() - made;  // that was ours
  Counting counting(run.simulation());
  LateTimes glTimes(picture_);
  FixedTimestep timestep;
  uint64_t droppedWarmingUp = 0;
  bool goOn = true;
  double last = now_ms();
  for (uint64_t n = 0; goOn && run.last().tick < plan.ticks; ++n) {
    Frame frame;
    stages.begin(n);
    const double begin = now_ms();
    if (plan.paced) timestep.frame(begin / 1000);
    while (run.last().tick < plan.ticks && (plan.paced ? timestep.due() : frame.ticks == 0)) {
      tick(run);
      ++frame.ticks;
    }
    frame.simulation_ms = now_ms() - begin;
    if (picture_) {
      const float passed_s = plan.paced ? float((begin - last) / 1000) : kTick_s;
      const float alpha = plan.paced ? timestep.alpha() : 1;
      const PictureCost cost = picture_->draw(run, config.rules, alpha, passed_s, scene_.title, !isSample(n));
      frame.draw_ms = cost.draw_ms;
      frame.wait_ms = cost.wait_ms;
      if (cost.timed) glTimes.expect(out.frames.size());
    }
    const double end = now_ms();
    frame.total_ms = end - begin;
    frame.begin_ms = begin - start;
    if (picture_ && frame.ticks > 0) frame.latency_ms = end - begin;
    last = begin;
    if (n == 0) out.timeToFirstFrame_ms = end - start;

    tell(frame, run.last(), plan);
    stages.end(frame, out.stages);
    if (frame.warmUp) droppedWarmingUp = timestep.dropped();
    if (plan.paced) {
      outsideOfPlay(timestep, [&] { counting.after(frame); });
    } else {
      counting.after(frame);
    }
    out.frames.push_back(std::move(frame));
    glTimes.takeInto(out.frames);
    goOn = listener(out.frames.back());
  }
  if (plan.paced) out.droppedTicks = double(timestep.dropped() - droppedWarmingUp);
  out.launchesPerTick = run.simulation().launchesPerTick();
  played.hash = run.last().hash;
  played.whole = run.last().tick == plan.ticks;
  return played;
}

// The arrangement is the shadow's own, kept from tick to tick as its upkeep leaves it; everything else is the exact
// run's.
PlayedRun Runner::playShadow(const SimulationConfig& config, const RunPlan& plan, const Listener& listener) {
  PlayedRun played;
  RunFrames& out = played.frames;
  out.shadow = true;
  SimulationConfig exactly = config;
  exactly.gather = Gather::exact;
  exactly.sort.reset();
  const std::unique_ptr<Simulation> exact = make_(exactly), shadow = make_(config);
  StageTimes stages(*shadow);
  Counting counting(*shadow);
  stages.beginAlways();
  const double start = now_ms();
  std::vector<uint32_t> arrangement;
  bool goOn = true;
  for (uint32_t tick = 0; goOn && tick < plan.ticks; ++tick) {
    const InputRecord& input = scene_.replay.inputs[tick];
    Snapshot state = exact->snapshot();
    state.arrangement = std::move(arrangement);
    shadow->restore(state);
    Frame frame;
    frame.begin_ms = now_ms() - start;
    shadow->tick(input);
    shadow->report();
    arrangement = shadow->snapshot().arrangement;
    exact->tick(input);
    const TickReport report = exact->report();
    check(report);

    frame.ticks = 1;
    frame.simulation_ms = frame.total_ms = kUnknown;
    tell(frame, report, plan);
    stages.end(frame, out.stages);
    counting.after(frame);
    out.frames.push_back(std::move(frame));
    played.hash = report.hash;
    goOn = listener(out.frames.back());
    played.whole = tick + 1 == plan.ticks;
  }
  out.launchesPerTick = shadow->launchesPerTick();
  return played;
}

}  // namespace gw::profile
