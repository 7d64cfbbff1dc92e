#include "common/output.hpp"

#include <GL/glew.h>

#include <cstdio>
#include <stb/stb_image_write.h>
#include <string>
#include <vector>

#include "common/files.hpp"

void save_screenshot(const std::filesystem::path& path, glm::ivec2 size)
{
    std::vector<unsigned char> pixels(3 * size_t(size.x) * size_t(size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());

    std::string png;
    stbi_flip_vertically_on_write(1);  // OpenGL's first row is the lowest
    stbi_write_png_to_func(
        [](void* out, void* data, int count) {
            static_cast<std::string*>(out)->append(static_cast<const char*>(data), size_t(count));
        },
        &png, size.x, size.y, 3, pixels.data(), 3 * size.x);
    write_file(path, png);
}

void dump_flakes(const std::filesystem::path& path, std::span<const snow::Particle> flakes)
{
    if (path.empty()) return;
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
