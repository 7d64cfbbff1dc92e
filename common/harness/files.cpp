#include "common/harness/files.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>
#ifndef _WIN32
#include <sys/stat.h>
#include <unistd.h>
#endif

#include "common/harness/process.hpp"

namespace fs = std::filesystem;

namespace {

// Is it no file that could be replaced, but a device, a pipe, or an open file by the name of its
// descriptor (/dev/stdout)? Such a thing is written to where it is.
bool is_written_in_place(const fs::path& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    const fs::path absolute = fs::absolute(path, error).lexically_normal();
    const std::string top = absolute.has_root_path() ? (*std::next(absolute.begin())).string() : "";
    return fs::exists(status) && !fs::is_directory(status) &&
           (!fs::is_regular_file(status) || top == "dev" || top == "proc");
}

// The file that is meant: where links lead, so that a link stays a link.
fs::path target_of(const fs::path& path)
{
    if (!fs::is_symlink(path)) return path;
    return fs::exists(path) ? fs::canonical(path) : path.parent_path() / fs::read_symlink(path);
}

// A new, empty file beside `target`, with a name that nothing had. Empty if there can be none;
// errno then says why.
fs::path make_part(const fs::path& target)
{
#ifdef _WIN32
    const fs::path part = fs::path(target) += ".snowfall-part";
    return std::ofstream(part, std::ios::binary).is_open() ? part : fs::path();
#else
    std::string name = target.string() + ".XXXXXX";
    const int descriptor = mkstemp(name.data());
    if (descriptor < 0) return {};
    const mode_t mask = umask(0);  // there is no other way to ask for it
    umask(mask);
    fchmod(descriptor, 0666 & ~mask);
    close(descriptor);
    return name;
#endif
}

[[noreturn]] void cannot_write(const fs::path& path, const std::string& reason)
{
    throw std::runtime_error("cannot write " + path.string() + ": " + reason +
                             " (choose a folder that exists and is yours to write)");
}

}  // namespace

fs::path path_of(std::string_view utf8)
{
    return std::u8string(utf8.begin(), utf8.end());
}

fs::path find_file(const std::string& name)
{
    std::vector<fs::path> folders;
    // An override is meant: with one, nothing else is looked at.
    if (const char* override_folder = std::getenv("SNOWFALL_DIR")) {
        folders = {path_of(override_folder)};
    } else {
        folders = {path_of(SNOWFALL_SOURCE_DIR), executable_folder(),
                   executable_folder().parent_path()};
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
    if (is_written_in_place(path)) return;  // to open a pipe would be to wait for who reads it
    const fs::path part = make_part(target_of(path));
    if (part.empty()) cannot_write(path, std::strerror(errno));
    std::error_code ignored;
    fs::remove(part, ignored);
}

void write_file(const fs::path& path, std::string_view bytes)
{
    if (fs::is_directory(path)) cannot_write(path, "it is a folder");
    const bool in_place = is_written_in_place(path);
    const fs::path target = in_place ? path : target_of(path);
    const fs::path part = in_place ? path : make_part(target);
    if (part.empty()) cannot_write(path, std::strerror(errno));
    errno = 0;
    // Behind what is there: /dev/stdout may be a log that goes on.
    std::ofstream file(part, in_place ? std::ios::binary | std::ios::app : std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    const std::string reason = file ? "" : std::strerror(errno);
    if (in_place && !file) cannot_write(path, reason);
    if (in_place) return;
    std::error_code error;
    if (file) fs::rename(part, target, error);
    if (file && !error) return;
    std::error_code ignored;
    fs::remove(part, ignored);
    cannot_write(path, file ? error.message() : reason);
}
