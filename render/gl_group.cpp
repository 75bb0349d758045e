#include "render/gl_group.h"

#include <GL/glew.h>

namespace gw {

GlGroup::GlGroup(const char* name) {
  glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
}

GlGroup::~GlGroup() {
  glPopDebugGroup();
}

}  // namespace gw
