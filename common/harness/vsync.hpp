// What GLUT has no function for: whether swapping buffers waits for the display, and letting go of
// a context.
#pragma once

// Asks the driver of the current context to wait, or not to. False if it cannot.
bool set_vsync(bool wait);

// "on" or "off" as the driver reports it, "off (not reported)" where it has no way to.
const char* vsync_state();

// Makes no context current. Where one is, it outlives even its window, and OpenGL would take the
// next window, if there is one in this process, to be on the display of the last.
void release_context();
