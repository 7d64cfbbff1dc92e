// What the window system has and GLUT lacks: waiting for the display, the title, the close button,
// letting go of a context.
#pragma once

// Asks the driver of the current context to wait, or not to. False if it cannot.
bool set_vsync(bool wait);

// "on" or "off" as the driver reports it, "off (not reported)" where it has no way to.
const char* vsync_state();

// Names the window of the current context.
void set_title(const char* title);

// Where a window that is closed takes its context along, calls `ask` instead of closing it.
// Elsewhere it does nothing, and glutCloseFunc tells of the close button.
void take_close_button(void (*ask)());

// Makes no context current. Where one is, it outlives even its window, and OpenGL would take the
// next window, if there is one in this process, to be on the display of the last.
void release_context();
