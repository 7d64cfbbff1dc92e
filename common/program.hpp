// Shader programs: GLSL files with #include, linked and checked.
#pragma once

#include <GL/glew.h>

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "common/bindings.glsl"
#include "common/gl_object.hpp"

struct Shader {
    GLenum type;       // GL_VERTEX_SHADER ...
    std::string file;  // relative to the source tree
};

class Program {
public:
    // Compiles and links. A line `#include "folder/file.glsl"` is replaced by that file. `varyings`
    // are the outputs that transform feedback captures, interleaved; `defines` are lines that every
    // shader gets below its first. Throws std::runtime_error with file, line and the compiler's
    // message.
    explicit Program(const std::vector<Shader>& shaders,
                     const std::vector<const char*>& varyings = {},
                     const std::string& defines = {});

    void use() const { glUseProgram(id_); }

    // Set a uniform of this program, which must be in use. A name that stands nowhere in
    // its sources is reported once on stderr; one that does may have been dropped as unused.
    void set(const char* name, int value) { glUniform1i(location(name), value); }
    void set(const char* name, unsigned value) { glUniform1ui(location(name), value); }
    void set(const char* name, float value) { glUniform1f(location(name), value); }
    void set(const char* name, glm::vec2 value) { glUniform2fv(location(name), 1, &value[0]); }
    void set(const char* name, glm::vec3 value) { glUniform3fv(location(name), 1, &value[0]); }
    void set(const char* name, const glm::mat4& value)
    {
        glUniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
    }

    // Binds a texture to a unit, of bindings.glsl, and tells the sampler of that name which it is.
    void set_texture(const char* name, GLuint unit, GLenum target, GLuint texture)
    {
        bind_texture(unit, target, texture);
        set(name, int(unit));
    }

private:
    GLint location(const char* name);

    GlObject id_;
    std::string files_, sources_;                          // for messages
    std::map<std::string, GLint, std::less<>> locations_;  // of the uniforms set so far
};
