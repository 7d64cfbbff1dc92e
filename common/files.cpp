#include "common/files.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace fs = std::filesystem;

fs::path path_of(std::string_view utf8)
{
    return std::u8string(utf8.begin(), utf8.end());
}

fs::path find_file(const std::string& name)
{
    const char* folder = std::getenv("SNOWFALL_DIR");
    const fs::path path = path_of(folder != nullptr ? folder : SNOWFALL_SOURCE_DIR) / name;
    if (fs::is_regular_file(path)) return path;
    throw std::runtime_error("cannot find " + path.string() +
                             " (set SNOWFALL_DIR to the folder that holds " + name + ")");
}

std::string read_file(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file || fs::is_directory(path)) {
        throw std::runtime_error("cannot read " + path.string() +
                                 " (is it a file, and yours to read?)");
    }
    return {std::istreambuf_iterator<char>(file), {}};
}
