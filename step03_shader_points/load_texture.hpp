// Pictures from PNG files.
#pragma once

#include <string>

#include "common/gl_object.hpp"

// A mipmapped RGBA texture of the picture `name`, relative to the source tree, left bound to
// GL_TEXTURE_2D. Throws std::runtime_error naming the file.
GlObject load_texture(const std::string& name);
