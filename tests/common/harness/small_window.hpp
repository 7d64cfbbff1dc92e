// For tests that need a window, and OpenGL with it.
#pragma once

#include "common/harness/harness.hpp"

// What the command line would be of a program of these snowflakes in 64 x 64 pixels.
inline CommandLine small_window(double minimum_gl, unsigned flakes = 7)
{
    CommandLine command;
    command.lesson.name = "test";
    command.lesson.minimum_gl = minimum_gl;
    command.lesson.variants = {{"plain", nullptr}};
    command.variant = "plain";
    command.weather = snow::make_weather("snow", flakes, 1);
    command.size = {64, 64};
    return command;
}
