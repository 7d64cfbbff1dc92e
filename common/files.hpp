// Finds and reads the files that a program needs: shaders, scenes and pictures.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

// The path that a UTF-8 text names, as in a scene or on a command line. (A path made from the text
// itself is the same on most systems, but MinGW's takes each byte for a letter.)
std::filesystem::path path_of(std::string_view utf8);

// The path of `name`, which is relative to the source tree ("step03_shader_points/flake.vert"): in
// the folder $SNOWFALL_DIR, or where that is not set, in the sources that this program was built
// from. Throws std::runtime_error if there is no such file.
std::filesystem::path find_file(const std::string& name);

// The whole file. Throws std::runtime_error.
std::string read_file(const std::filesystem::path& path);
