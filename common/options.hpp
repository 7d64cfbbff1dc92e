// The command line, the same for all six programs.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/camera.hpp"
#include "common/snow.hpp"

// A number that only one step has, changed like those of the weather.
struct Setting {
    const char* name;
    const char* unit;
    float least, most;
    float value;
    const char* meaning;
    char key = 0;  // that turns a switch on and off
};

// A part of the step that can be switched off.
constexpr Setting a_switch(const char* name, bool on, const char* meaning, char key = 0)
{
    return {name, "on/off", 0, 1, on ? 1.0f : 0.0f, meaning, key};
}

// What a step tells about itself.
struct Step {
    std::string name;                          // "step01_cpu_points"
    std::string idea;                          // one sentence for --help
    double least_gl;                           // OpenGL version, 3.3
    std::vector<std::string> variants;         // the first is the default
    bool has_scene = false;                    // takes --scene, --voxels and --up
    bool has_cover = false;                    // takes --dump-cover
    bool fixed_points = false;                 // takes --groups and --point-size
    std::vector<const char*> extensions = {};  // needed besides the version
    std::vector<Setting> settings = {};        // of its own
};

struct Options {
    Step step;
    std::string variant;
    snow::Weather weather{};        // with particles, seed and every --set already in it
    std::filesystem::path scene;    // where has_scene: the courtyard unless given
    char up = 'y';                  // the axis that points up in the scene file
    int voxels = 256;               // along the longest axis of the scene
    glm::ivec2 size = {1280, 720};  // pixels
    Camera camera;                  // as it stands at the start
    bool tour = false;              // fly it through the courtyard
    bool vsync = false;
    std::optional<unsigned> frames;  // stop after so many
    unsigned warmup = 0;             // frames before the first that counts
    unsigned timelapse = 1;          // steps of physics in place of one
    bool realtime = false;  // steps follow the clock even when --frames, --dump ... are given
    unsigned groups = 2;    // pieces in which the pool is drawn
    float point_size = 1;   // pixels, of emitter 0's flakes; emitter 1's are twice as wide
    bool benchmark = false;
    std::filesystem::path screenshot, dump, dump_cover, csv;
    std::filesystem::path record;  // folder for a picture of every frame
    bool debug = false;

    // As many physics steps in every frame, so that a run can be repeated exactly?
    bool reproducible() const
    {
        return !realtime && (benchmark || frames || !screenshot.empty() || !dump.empty() ||
                             !dump_cover.empty() || !record.empty());
    }

    // All that --set and the panel's sliders change: the weather, then the step's own settings.
    std::vector<snow::Parameter> parameters();

    // A setting of the step. Throws std::logic_error if it has none of that name.
    float setting(std::string_view name) const;
    bool on(std::string_view name) const { return setting(name) != 0; }

    // The first flake of a group; of group `groups`, one past the last of all.
    unsigned group_begin(unsigned group) const
    {
        return unsigned(uint64_t(weather.particles) * group / groups);
    }
};

// What the keys do in a step, for --help and for the panel.
std::string keys_help(const Step& step);

// Parses and checks the command line. --help ends the program with status 0, a line that makes no
// sense with 2; what cannot be done (an output that cannot be written) throws std::runtime_error.
Options parse_options(int argc, char** argv, Step step);
