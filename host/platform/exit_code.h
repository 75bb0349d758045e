// How the program ends, for scripts: docs/reference/files.md says which command gives which.
#pragma once

namespace gw {

// `differ` is what diff says, as the program of that name does.
enum class ExitCode : int { fine = 0, failedRun = 1, differ = 1, badUsage = 2, badFile = 3, desync = 4 };

}  // namespace gw
