// What a user can do about an error of the system, in one place for everything that is written.
#pragma once

#include <string>
#include <string_view>

namespace gw {

// "make room or choose another disk"
const char* remedyFor(int error);

// The system's words for `error`, and the remedy: the end of a sentence, without its full stop.
std::string because(int error);

// The same for a folder that could not be made.
std::string becauseNoFolder(int error);

// The errno that `text`, which another program wrote, names in the system's words: of those about folders, permissions
// and room on a disk; 0 when it names none of them.
int errorNamedIn(std::string_view text);

}  // namespace gw
