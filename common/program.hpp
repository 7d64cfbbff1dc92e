// Shader programs: GLSL files with #include, linked and checked.
#pragma once

#include <GL/glew.h>

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "common/gl_object.hpp"
#include "common/snow.hpp"

struct Stage {
    GLenum type;       // GL_VERTEX_SHADER ...
    std::string file;  // relative to the source tree
};

class Program {
public:
    // Compiles and links. A line `#include "folder/file.glsl"` is replaced by that file. `varyings`
    // are the outputs that transform feedback captures, interleaved. Throws std::runtime_error with
    // file, line and the compiler's message.
    explicit Program(const std::vector<Stage>& stages,
                     const std::vector<const char*>& varyings = {});

    void use() const { glUseProgram(id_); }

    // Set a uniform of this program, which must be in use. A name that stands nowhere in
    // its sources is reported once on stderr; one that does may have been dropped as unused.
    void set(const char* name, int value);
    void set(const char* name, unsigned value);
    void set(const char* name, float value);
    void set(const char* name, glm::ivec2 value);
    void set(const char* name, glm::vec3 value);
    void set(const char* name, const glm::mat4& value);

private:
    GLint location(const char* name);

    GlObject id_;
    std::string files_, sources_;                          // for messages
    std::map<std::string, GLint, std::less<>> locations_;  // of the uniforms set so far
};

// Makes `weather` the contents of every program's uniform block WeatherBlock. Call it again after a
// change; keep the result as long as it is needed.
GlObject upload_weather(const snow::Weather& weather);
