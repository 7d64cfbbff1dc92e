#include "common/harness/recorder.hpp"

#include <GL/glew.h>

#include <cstdio>
#include <iostream>
#include <stb_image_write.h>
#include <string>

#include "common/gl_object.hpp"
#include "common/harness/files.hpp"

Picture read_back_buffer(glm::ivec2 size)
{
    Picture picture{size, std::vector<unsigned char>(3 * size_t(size.x) * size_t(size.y))};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, picture.pixels.data());
    check_read_back("the picture");
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

// Where this cannot be written, here and now, it is no reason to end the run and lose its results.
static void save_for_user(const std::filesystem::path& path, const Picture& picture)
try {
    write_png(path, picture);
} catch (const std::exception& failure) {
    std::cerr << "warning: " << failure.what() << std::endl;
}

void record_frame(const CommandLine& command, uint64_t number, bool last, bool asked,
                  const std::function<Picture()>& grab)
{
    std::vector<std::filesystem::path> paths;
    if (last && !command.screenshot.empty()) paths.push_back(command.screenshot);
    if (!command.record.empty() && number >= 1) {
        char name[32];
        std::snprintf(name, sizeof name, "%06llu.png", static_cast<unsigned long long>(number));
        paths.push_back(command.record / name);
    }
    if (paths.empty() && !asked) return;
    const Picture picture = grab();
    for (const std::filesystem::path& path : paths) write_png(path, picture);
    if (asked) save_for_user(command.lesson.name + ".png", picture);
}
