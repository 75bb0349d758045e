// Opens game controllers as they are connected, and closes them when they go: only an open one sends events.
#pragma once

#include <SDL_events.h>
#include <SDL_gamecontroller.h>

#include <memory>
#include <string>
#include <vector>

namespace gw {

class PadDevices {
 public:
  // Starts SDL's game controllers and opens those that are connected. Where that fails there are no pads, and problem()
  // says why.
  PadDevices();
  ~PadDevices();
  PadDevices(const PadDevices&) = delete;
  PadDevices& operator=(const PadDevices&) = delete;

  // SDL_CONTROLLERDEVICEADDED and SDL_CONTROLLERDEVICEREMOVED; others mean nothing here.
  void handle(const SDL_Event& event);

  size_t connected() const { return pads_.size(); }
  const std::string& problem() const { return problem_; }  // one sentence; empty: none

 private:
  struct Close {
    void operator()(SDL_GameController* pad) const { SDL_GameControllerClose(pad); }
  };
  using Pad = std::unique_ptr<SDL_GameController, Close>;
  void open(int device);
  static SDL_JoystickID idOf(const Pad& pad);

  std::vector<Pad> pads_;
  bool started_ = false;
  std::string problem_;
};

}  // namespace gw
