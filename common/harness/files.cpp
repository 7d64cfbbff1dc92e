#include "common/harness/files.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace fs = std::filesystem;

namespace {

fs::path executable_folder()
{
    std::error_code error;
    const fs::path executable = fs::read_symlink("/proc/self/exe", error);  // Linux; elsewhere the
    return error ? fs::current_path() : executable.parent_path();           // current folder serves
}

// Where a file is written first. Beside what a link points to, so that the link stays a link; and
// at once to what is no file at all: /dev/null is not to be replaced by one.
fs::path part_of(const fs::path& path)
{
    fs::path target = path;
    if (fs::is_symlink(path)) {
        target =
            fs::exists(path) ? fs::canonical(path) : path.parent_path() / fs::read_symlink(path);
    }
    if (fs::exists(target) && !fs::is_regular_file(target)) return target;
    return target += ".part";
}

void remove_part(const fs::path& path)
{
    std::error_code ignored;
    if (fs::is_regular_file(part_of(path), ignored)) fs::remove(part_of(path), ignored);
}

[[noreturn]] void cannot_write(const fs::path& path, const std::string& reason)
{
    remove_part(path);
    throw std::runtime_error("cannot write " + path.string() + ": " + reason +
                             " (choose a folder that exists and is yours to write)");
}

}  // namespace

fs::path find_file(const std::string& name)
{
    std::vector<fs::path> folders;
    // An override is meant: with one, nothing else is looked at.
    if (const char* override_folder = std::getenv("SNOWFALL_DIR")) {
        folders = {override_folder};
    } else {
        folders = {SNOWFALL_SOURCE_DIR, executable_folder(), executable_folder().parent_path()};
    }
    std::string tried;
    for (const fs::path& folder : folders) {
        if (fs::is_regular_file(folder / name)) return folder / name;
        tried += (tried.empty() ? "" : ", ") + (folder / name).string();
    }
    throw std::runtime_error("cannot find " + name + " (tried " + tried +
                             "; set SNOWFALL_DIR to the folder that holds it)");
}

std::string read_file(const fs::path& path)
{
    if (fs::is_directory(path))
        throw std::runtime_error("cannot read " + path.string() + ": a folder");
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (file) text << file.rdbuf();
    if (!file) {
        throw std::runtime_error("cannot read " + path.string() + ": " +
                                 (fs::exists(path) ? "no permission, or empty" : "no such file"));
    }
    return text.str();
}

void check_writable(const fs::path& path)
{
    if (fs::is_directory(path)) cannot_write(path, "it is a folder");
    errno = 0;
    const bool opened = std::ofstream(part_of(path), std::ios::app | std::ios::binary).is_open();
    if (!opened) cannot_write(path, std::strerror(errno));
    remove_part(path);
}

void write_file(const fs::path& path, std::string_view bytes)
{
    const fs::path part = part_of(path);
    errno = 0;
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) cannot_write(path, std::strerror(errno));
    if (part.extension() != ".part") return;  // written where it belongs
    std::error_code error;
    fs::rename(part, fs::path(part).replace_extension(), error);
    if (error) cannot_write(path, error.message());
}
