// One file takes the place of another: the one policy for everything that is written.
#pragma once

#include <filesystem>
#include <string>

#include "host/platform/atomic_file.h"

namespace gw {

// `part`, which is whole, becomes `target`: by its name, in one step. Where the system does not let go of
// the old name - a file that is a mount point of its own, as a container's may be, or one of another user in a
// folder like /tmp - the bytes are written into the old file instead, once room for them has been reserved. Throws
// FileError about `shown`: the target is then untouched and the part still there; but when a disk fails in the middle
// of writing bytes, the sentence names the part, which is whole, and `part` is emptied so that it is not removed.
void replaceFile(std::string& part, const std::filesystem::path& target, const std::filesystem::path& shown, Sync sync);

}  // namespace gw
