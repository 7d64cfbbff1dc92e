// Whether swapping buffers waits for the display.
#pragma once

// Asks the driver of the current context to wait, or not to. False if it cannot.
bool set_vsync(bool wait);

// "on" or "off" as the driver reports it, "off (not reported)" where it has no way to.
const char* vsync_state();
