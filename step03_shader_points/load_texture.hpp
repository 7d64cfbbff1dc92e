// Pictures from PNG, JPEG and TGA files.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/gl_object.hpp"

struct Image {
    int width, height;  // pixels
    int channels;       // of the file: 1 grey, 2 and alpha, 3 red, green, blue, 4 and alpha
    std::unique_ptr<unsigned char, void (*)(void*)> pixels;  // 4 channels each, lowest row first
};

// Throws std::runtime_error naming the file if it is broken or too large.
Image read_picture(const std::filesystem::path& path);

// A mipmapped texture, left bound to GL_TEXTURE_2D.
GlObject upload_picture(const Image& picture);

// Both at once, for the picture `name` of ours, relative to the source tree.
GlObject load_texture(const std::string& name);
