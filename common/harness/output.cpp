#include "common/harness/output.hpp"

#include <GL/glew.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

#ifdef STB_HAS_NO_LIBRARY  // its headers become code here
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image.h>
#endif
#include <stb_image_write.h>

#include "common/gl_object.hpp"

namespace fs = std::filesystem;

[[noreturn]] static void cannot_write(const fs::path& path)
{
    throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(errno) +
                             " (choose a folder that exists and is yours to write)");
}

void check_writable(const fs::path& path)
{
    const bool was_there = fs::exists(path);
    if (!std::ofstream(path, std::ios::app).is_open()) cannot_write(path);
    if (!was_there) fs::remove(path);
}

void write_file(const fs::path& path, std::string_view bytes)
{
    const bool in_place = fs::exists(path) && (fs::is_symlink(path) || !fs::is_regular_file(path));
    const fs::path written = in_place ? path : fs::path(path) += ".part";
    std::ofstream file(written, std::ios::binary);
    file.write(bytes.data(), std::streamsize(bytes.size()));
    file.close();
    std::error_code error;
    if (file && !in_place) fs::rename(written, path, error);
    if (file && !error) return;
    if (!in_place) fs::remove(written, error);
    cannot_write(path);
}

std::string png_of_back_buffer(glm::ivec2 size)
{
    std::vector<unsigned char> pixels(3 * size_t(size.x) * size_t(size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    check_read_back("the picture");
    std::string png;
    const auto append = [](void* to, void* bytes, int count) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), size_t(count));
    };
    stbi_flip_vertically_on_write(1);  // OpenGL's first row is the lowest
    stbi_write_png_to_func(append, &png, size.x, size.y, 3, pixels.data(), 3 * size.x);
    return png;
}

void write_dump(const fs::path& path, std::span<const snow::Particle> flakes)
{
    std::string csv = "index,x,y,z,age,vx,vy,vz,rest\n";
    char line[256];
    for (size_t i = 0; i < flakes.size(); ++i) {
        const snow::Particle& p = flakes[i];
        std::snprintf(line, sizeof line, "%zu,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", i,
                      p.position.x, p.position.y, p.position.z, p.age, p.velocity.x, p.velocity.y,
                      p.velocity.z, p.rest);
        csv += line;
    }
    write_file(path, csv);
}
