// The pictures that a run leaves: of its last frame, of every frame, or when the key S is pressed.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "common/harness/options.hpp"

struct Picture {
    glm::ivec2 size{};                  // pixels
    std::vector<unsigned char> pixels;  // red, green, blue; the lowest row first
};

// What is in the back buffer.
Picture read_back_buffer(glm::ivec2 size);

// Writes it as a PNG. Throws std::runtime_error.
void write_png(const std::filesystem::path& path, const Picture& picture);

// Writes every picture that a frame is to leave; its number is 1 for the first that counts.
// `asked`: by the user, just now. `grab` takes the picture, and is called only if one is wanted.
// Throws std::runtime_error.
void record_frame(const CommandLine& command, uint64_t number, bool last, bool asked,
                  const std::function<Picture()>& grab);
