// A name around the GL calls of a pass, so that RenderDoc, Nsight and debug messages show passes by name. Costs nothing
// worth measuring without a debugger attached. In core since OpenGL 4.3, so every context of ours has it.
#pragma once

namespace gw {

class GlGroup {
 public:
  // name: as tools show it, e.g. "sprites".
  explicit GlGroup(const char* name);
  ~GlGroup();
  GlGroup(const GlGroup&) = delete;
  GlGroup& operator=(const GlGroup&) = delete;
};

}  // namespace gw
