// Ctrl-C as a wish: long work looks now and then whether somebody wants it to end, and ends cleanly.
#pragma once

namespace gw {

// From here SIGINT and SIGTERM only set the flag; a second one ends the program at once.
void catchInterrupts();
bool interrupted();

}  // namespace gw
