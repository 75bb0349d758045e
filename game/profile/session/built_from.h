// What this program was built from and with; the definition is made by built_from.cmake at every build.
#pragma once

namespace gw::profile {

extern const char* const kCommit;  // "" outside of a git checkout; ends in "+" when files differed from it
extern const char* const kCompiler;
extern const char* const kCompilerFlags;

}  // namespace gw::profile
