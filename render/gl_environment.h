// Environment variables by which users and other programs choose an OpenGL driver, or hold one back. Where one is set
// and no OpenGL 4.5 comes, it is the likely cause, and installing a driver would not help.
#pragma once

#include <functional>
#include <string>

namespace gw {

// What the environment holds under a name; null: nothing. Tests bring their own.
using Environment = std::function<const char*(const char* name)>;
const char* processEnvironment(const char* name);

// What to do about a missing OpenGL 4.5: of the variables that are set, else `otherwise`. No full stop.
std::string glRemedy(const std::string& otherwise, const Environment& environment = processEnvironment);

}  // namespace gw
