// Dear ImGui in the game's window: its context, its events and its pictures. It gets the mouse only where it is offered
// to it, never a key, and writes no file.
#pragma once

#include <SDL_events.h>

#include "render/gl_context_sdl.h"

namespace gw {

class ImGuiLayer {
 public:
  // Needs a current GL context of this window; there is one layer at a time.
  explicit ImGuiLayer(SdlContext& context);
  ~ImGuiLayer();
  ImGuiLayer(const ImGuiLayer&) = delete;
  ImGuiLayer& operator=(const ImGuiLayer&) = delete;

  // True when it is a press or a turn of the wheel over one of its windows: that goes no further.
  bool handle(const SDL_Event& event);

  // Between the two windows are drawn by ImGui's own calls.
  void begin();
  void end();

 private:
  SdlContext& context_;
};

}  // namespace gw
