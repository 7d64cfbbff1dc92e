// What OpenGL and the window system are here, and whether they will do.
#pragma once

#include <functional>
#include <string>

struct Lesson;

// Ends the program with one line where GLUT finds no display, or none that it can use.
void report_glut_errors();

// Loads OpenGL's functions into GLEW. debug: prints every message of the driver from now on. Throws
// std::runtime_error if the OpenGL of the current context lacks what that or the step needs.
void load_opengl(const Lesson& lesson, bool debug);

// Does the driver say that it has this extension? "GL_ARB_...", which may be part of its version.
bool has_extension(const char* name);

// As it was while there was a context to ask.
const std::string& renderer_name();

// Is there no graphics card behind this OpenGL?
bool renders_in_software();

// ---- What the window system has and GLUT lacks: window_system.cpp

// Asks the driver of the current context to wait for the display, or not to. Returns "on" or "off",
// or "off (not reported)" where it has no such thing; null if it cannot wait.
const char* set_vsync(bool wait);

// Names the window of the current context.
void set_title(const char* title);

// Where a window that is closed takes its context along, calls `ask` instead of closing it.
// Elsewhere it does nothing, and glutCloseFunc tells of the close button.
void take_close_button(const std::function<void()>& ask);

// Memory that this process has in use, MiB; 0 where the system does not tell.
double process_memory();
