// The window as GLUT makes it, and what OpenGL and the window system are here.
#pragma once

#include <functional>
#include <string>

struct CommandLine;

// Opens the window with an OpenGL context that is current. Where GLUT finds no display that it can
// use it ends the program with one line. Throws std::runtime_error if this OpenGL lacks what the
// step needs.
void open_window(const CommandLine& command);

// As it was while there was a context to ask.
const std::string& renderer_name();

// Is there no graphics card behind this OpenGL?
bool renders_in_software();

// ---- What the window system has and GLUT lacks: window_system.cpp

// Has the driver wait for the display, or not. False: it cannot be told.
bool set_vsync(bool wait);

// Names the window of the current context.
void set_title(const char* title);

// Has the program say so, in one line, if the display goes and ends it.
void watch_display();

// Is stderr a terminal, at which somebody may be waiting?
bool is_watched();

// Where a window that is closed takes its context along, calls `ask` instead of closing it.
// Elsewhere it does nothing, and glutCloseFunc tells of the close button.
void take_close_button(const std::function<void()>& ask);
