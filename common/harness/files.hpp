// Finding the files a program reads, and writing the ones it makes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

// The path that a text means which is UTF-8, as names in a scene or on a command line are (that of
// Windows by windows/utf8.manifest). A std::filesystem::path made from the text itself is the same
// thing on most systems, but MinGW's takes each byte for a letter. Throws std::system_error where
// Windows is given what is no UTF-8.
std::filesystem::path path_of(std::string_view utf8);

// The path of `name`, given relative to the source tree ("step03_shader_points/flake.vert"),
// wherever the program was started from. Looks in $SNOWFALL_DIR, the source folder compiled in, and
// the executable's folder. Throws std::runtime_error listing every path tried.
std::filesystem::path find_file(const std::string& name);

// The whole file. Throws std::runtime_error naming it.
std::string read_file(const std::filesystem::path& path);

// Throws std::runtime_error unless `path` can be written: asked at the start, not after the last
// frame.
void check_writable(const std::filesystem::path& path);

// Writes the file whole or not at all: beside it first, then renamed. Throws std::runtime_error.
void write_file(const std::filesystem::path& path, std::string_view bytes);
