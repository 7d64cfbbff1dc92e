// The command line, the same for all six programs.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/camera.hpp"
#include "common/lesson.hpp"

// All of it: what a variant may want to know, and what only the harness does.
struct CommandLine : Options {
    Lesson lesson;
    glm::ivec2 size = {1280, 720};  // pixels
    Camera camera;                  // as it stands at the start
    bool tour = false;              // fly it through the courtyard
    bool vsync = false, fullscreen = false;
    std::optional<unsigned> frames;  // to stop after
    unsigned warmup = 0;             // frames before the first that counts; see harness.cpp
    bool realtime = false;  // steps follow the clock even when --frames, --dump ... are given
    bool benchmark = false;
    std::filesystem::path screenshot, dump, csv;
    std::filesystem::path record;  // folder for a picture of every frame
    bool debug = false;
    std::set<std::string> decided;  // parameters that --set has set

    // As many time steps in every frame, so that a run can be repeated exactly?
    bool reproducible() const
    {
        return !realtime && (benchmark || frames || !screenshot.empty() || !dump.empty() ||
                             !dump_cover.empty() || !record.empty());
    }

    // The variant asked for.
    const Variant& chosen() const;

    // All that --set and the panel's sliders change: the weather, then the variant's own numbers.
    std::vector<snow::Parameter> parameters();
};

// What the keys do, for --help and for the panel.
std::string keys_help(const std::vector<snow::Parameter>& parameters);

// Parses and checks the command line. --help ends the program with status 0, a line that makes no
// sense with 2; what cannot be done (an output that cannot be written) throws std::runtime_error.
CommandLine parse_command_line(int argc, char** argv, const Lesson& lesson);
