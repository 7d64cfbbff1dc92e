// What a step declares of itself, and what its user has asked of it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "common/weather.hpp"

class Window;

// A way of doing it, chosen with --variant.
struct Variant {
    std::string name;
    // Runs it from the first flake to the last frame, or until the user begins anew.
    std::function<void(Window&)> run;
    // The numbers and switches that only this variant has, for --set and the panel.
    std::vector<snow::Parameter> parameters = {};
};

// Something that the specification allows a card to have none of, and the step needs.
struct Limit {
    unsigned name;     // GL_MAX_VERTEX_...
    int minimum;       // that will do
    const char* what;  // in words
};

struct Lesson {
    std::string name;                          // that of its folder
    std::string idea;                          // one sentence for --help
    double minimum_gl = 0;                     // OpenGL version, 3.3
    std::vector<Variant> variants;             // the first is the default
    bool fixed_points = false;                 // takes --groups and --point-size
    bool has_scene = false;                    // takes --scene, --collision, --voxels, ...
    bool has_cover = false;                    // takes --dump-cover
    std::vector<const char*> extensions = {};  // that OpenGL must have besides its version
    std::vector<Limit> limits = {};
};

// What a variant may want to know of the command line.
struct Options {
    std::string variant;
    snow::Weather weather{};      // with particles, seed and every --set already in it
    unsigned timelapse = 1;       // time steps instead of one
    unsigned groups = 2;          // pieces in which the pool is drawn
    float point_size = 1;         // pixels, of emitter 0's flakes; emitter 1's are twice as wide
    std::filesystem::path scene;  // where has_scene: the courtyard unless given
    std::filesystem::path collision;  // other triangles to land on; empty: those of the scene
    char up = 'y';                    // the axis that points up in the scene file
    bool metres = false;              // they are in metres, and keep their size
    int voxels = 256;                 // along the longest axis of the scene
    std::string voxeliser = "cpu";    // where the grid is made, or "gpu"
    std::filesystem::path dump_cover;
};

// The whole of a step's program: takes the command line, opens the window and runs the variant
// asked for until the user has had enough. Returns the exit status: 0 done, 1 cannot run, after one
// line on stderr that says why. (A wrong command line ends the program with 2.)
int run_lesson(int argc, char** argv, const Lesson& lesson);
