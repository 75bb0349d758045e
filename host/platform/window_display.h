// Whether a window can be opened here. Only in builds with GW_WINDOW.
#pragma once

namespace gw {

// Decides what SDL would find out noisily, for its Wayland client complains on stderr when there is none, and what its
// versions decide differently: X11 where there is an X server, else Wayland. SDL_VIDEODRIVER overrules it. Throws
// UserError when there is no display.
void chooseDisplay();

}  // namespace gw
