// Ctrl-C, SIGTERM and a terminal that is closed, as a wish: long work looks now and then whether it was asked to
// end, and ends cleanly.
#pragma once

namespace gw {

// From here SIGINT, SIGTERM and SIGHUP only set the flag. The same one again, SIGHUP apart, ends the program at once,
// but not within a moment of the first: timeout(1) sends its signal twice. SIGHUP stays ignored where it was, as by
// nohup.
void catchInterrupts();
bool interrupted();

// What the program ends with: 128 and the signal that asked for its end, as shells count it. What `code` says otherwise
// stays where it tells more than that the run failed.
int exitStatus(int code);

}  // namespace gw
