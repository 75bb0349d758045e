// A profiling session: the same scene, played by one contender after the other, again and again (A B A B), so that a
// machine that grows warm or busy does so for all of them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "game/profile/metrics/report.h"
#include "game/profile/session/machine.h"
#include "game/profile/session/processor_watch.h"
#include "game/profile/session/runner.h"

namespace gw::profile {

enum class Drawn : uint32_t { window, offscreen, nothing };

struct SessionPlan {
  SceneKind scene = SceneKind::fiveMinutes;
  std::filesystem::path replay;         // instead of a scene; empty: none
  std::vector<uint32_t> enemies{8192};  // a case each; one alone with a replay
  uint32_t ticks = 0;                   // 0: all of the scene
  uint32_t runs = 10;
  bool paced = false;
  std::vector<ContenderChoice> contenders;
  Drawn drawn = Drawn::window;
  PixelSize size{1280, 720};
  Look look;
};

// Where a session is; for people who wait.
struct SessionProgress {
  std::string doing;     // "five-minutes, 8,192 enemies: run 3 of 10, grid"
  uint32_t tick, ticks;  // of this run, or of the recording of the scene
  double left_s;         // of the whole session, if further numbers of enemies cost the same; unknown at first
};

class Session {
 public:
  // The frames of a run that is over, in the order in which runs end.
  using RunListener = std::function<void(uint32_t enemies, const ContenderChoice&, uint32_t run, const RunFrames&)>;
  // What will be measured; before the first run. May throw, to refuse it.
  using SetupListener = std::function<void(const Setup&)>;
  // False: end it, with what there is.
  using ProgressListener = std::function<bool(const SessionProgress&)>;

  // `computing` holds what the command line says about how to compute. Every simulation must come on the same device.
  Session(SessionPlan plan, SimulationConfig computing, std::filesystem::path assets, MakeSimulation device);
  ~Session();

  // Throws UserError, ReplayError, and SceneDesync when a run does not reach the recorded hashes. A session without a
  // single frame, or whose device changes, throws UserError.
  Report run(const SetupListener& setups, const RunListener& runs, const ProgressListener& progress);

 private:
  struct CaseRuns;
  void begin();
  Scene sceneFor(uint32_t enemies);
  void openScreen(bool onCuda);
  std::unique_ptr<Simulation> make(const SimulationConfig& config);
  Case playCase(const Scene& scene, size_t index, const SetupListener& setups);
  void finish(Case& played, const CaseRuns& of);
  void playRun(const Scene& scene, uint32_t enemies, uint32_t round, CaseRuns& of, size_t contender);
  bool tell(const std::string& doing, uint32_t tick, uint32_t ticks, double left_s);
  double left_s() const;
  Setup setupOf(const Scene& first) const;
  void warn(Report& report, const MachineUse& use, const ProcessorWatch& processors) const;

  SessionPlan plan_;
  SimulationConfig computing_;
  std::filesystem::path assets_;
  MakeSimulation device_;
  RuleTexts rules_;
  RunListener runListener_;
  ProgressListener progressListener_;
  std::optional<Screen> screen_;
  PixelSize size_;  // what it is, which a window's manager decides
  Setup setup_;
  std::string deviceName_;
  bool ended_ = false;  // it was asked to end
  uint32_t madeRuns_ = 0;
  std::vector<double> tickCost_s_;     // by contender, of its last run; 0: not known yet
  std::vector<uint64_t> ticksToGo_;    // by contender
  std::vector<double> timersCost_;     // share, of each run
  std::vector<GpuState> gpu_;          // after each run
  std::vector<std::string> cutShort_;  // contenders that nothing is compared with
};

}  // namespace gw::profile
