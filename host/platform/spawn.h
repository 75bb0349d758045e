// Starts another program from an argument vector: no shell ever sees a file name.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace gw {

// Standard streams of the program; -1: this program's own.
struct ProgramStreams {
  int in = -1, out = -1, error = -1;
};

// In a process group of its own, so that Ctrl-C at the terminal is this program's alone, and with the usual SIGPIPE.
// Throws std::system_error when it cannot be started; ENOENT when it is not installed.
pid_t spawn(const std::vector<std::string>& arguments, const ProgramStreams& streams);

// Gives it so long to end by itself, then kills its group.
void endWithin(pid_t program, double seconds);

// Waits for its end: its exit code, or 128 and the signal that ended it.
int waitFor(pid_t program);

}  // namespace gw
