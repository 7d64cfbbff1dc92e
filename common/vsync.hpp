// Whether swapping buffers waits for the display.
#pragma once

// Asks the driver of the current context to wait, or not to. False if it cannot.
bool set_vsync(bool wait);
