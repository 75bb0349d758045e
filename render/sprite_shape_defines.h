// The table of shapes as the sprite shaders read it.
#pragma once

#include <string>

namespace gw {

// Lines of #define: SHAPES, and of each member a list SHAPE_... with an entry per shape, in the order of Shape.
std::string spriteShapeDefines();

}  // namespace gw
