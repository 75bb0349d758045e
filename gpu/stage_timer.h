// Time per named stage, in the order in which the stages first ran: a steady clock around the launch and a
// synchronisation (nothing to wait for on cpu), so timed runs on cuda are not captured. Off, one branch.
#pragma once

#include <chrono>
#include <cstring>
#include <string>
#include <vector>

#include "gpu/exec.h"

namespace gw::GW_DEVICE {

class StageTimer {
 public:
  struct Stage {
    std::string name;
    double total_ms = 0;
    uint64_t calls = 0;
  };

  void enable(bool on) { on_ = on; }
  const std::vector<Stage>& stages() const { return stages_; }

  // Runs launch() and adds its time to the stage of this name.
  template <class Launch>
  void time(Queue& queue, const char* name, const Launch& launch) {
    if (!on_) {
      launch();
      return;
    }
    const auto begin = std::chrono::steady_clock::now();
    launch();
    queue.synchronise();
    const auto end = std::chrono::steady_clock::now();
    Stage& stage = find(name);
    stage.total_ms += std::chrono::duration<double, std::milli>(end - begin).count();
    ++stage.calls;
  }

 private:
  Stage& find(const char* name) {
    for (Stage& stage : stages_) {
      if (stage.name == name) return stage;
    }
    return stages_.emplace_back(Stage{name});
  }

  bool on_ = false;
  std::vector<Stage> stages_;
};

}  // namespace gw::GW_DEVICE
