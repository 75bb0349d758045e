// Whether a window can be opened here. Only in builds with GW_WINDOW.
#pragma once

namespace gw {

// Decides what SDL would find out noisily: its Wayland client complains on stderr when there is none. Throws UserError
// when there is no display.
void chooseDisplay();

}  // namespace gw
