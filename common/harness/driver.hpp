// What OpenGL this is, and whether it will do.
#pragma once

#include <string>

#include "common/lesson.hpp"

// Ends the program with one line where GLUT finds no display, or none that it can use.
void report_glut_errors();

// From now on Ctrl-C and SIGTERM only ask for an end, so that what was computed can be written; the
// second ends the program at once.
void catch_interrupts();
bool interrupted();

// Loads OpenGL's functions into GLEW. Throws std::runtime_error if there are none.
void load_opengl();

// Throws std::runtime_error if the OpenGL of the current context lacks what the step needs.
void check_opengl(const Lesson& lesson);

// Prints every message of the driver on stderr from now on. Throws std::runtime_error if it has
// none.
void print_debug_messages();

// Does the driver say that it has this extension? "GL_ARB_...", which may be part of its version.
bool has_extension(const char* name);

std::string renderer_name();

// Is there no graphics card behind this OpenGL?
bool renders_in_software();
