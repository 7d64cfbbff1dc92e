#include "common/harness/recorder.hpp"

#include <GL/glew.h>

#include <cstdio>
#include <stb/stb_image_write.h>
#include <string>

#include "common/harness/files.hpp"

Picture read_back_buffer(glm::ivec2 size)
{
    Picture picture{size, std::vector<unsigned char>(3 * size_t(size.x) * size_t(size.y))};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, picture.pixels.data());
    return picture;
}

void write_png(const std::filesystem::path& path, const Picture& picture)
{
    std::string png;
    stbi_flip_vertically_on_write(1);  // OpenGL's first row is the lowest
    stbi_write_png_to_func(
        [](void* out, void* data, int count) {
            static_cast<std::string*>(out)->append(static_cast<const char*>(data), size_t(count));
        },
        &png, picture.size.x, picture.size.y, 3, picture.pixels.data(), 3 * picture.size.x);
    write_file(path, png);
}

void record_frame(const CommandLine& command, unsigned number, bool last, bool asked,
                  const std::function<Picture()>& grab)
{
    std::vector<std::filesystem::path> paths;
    if (last && !command.screenshot.empty()) paths.push_back(command.screenshot);
    if (!command.record.empty() && number >= 1) {
        char name[32];
        std::snprintf(name, sizeof name, "%06u.png", number);
        paths.push_back(command.record / name);
    }
    if (asked) paths.push_back(command.lesson.name + ".png");
    if (paths.empty()) return;
    const Picture picture = grab();
    for (const std::filesystem::path& path : paths) write_png(path, picture);
}
