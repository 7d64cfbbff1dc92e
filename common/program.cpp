#include "common/program.hpp"

#include <iostream>
#include <stdexcept>

#include "common/harness/shader_source.hpp"
#include "common/snow.hpp"

namespace {

GlObject compile(const Shader& shader, const std::string& defines, std::string& all_sources)
{
    const ShaderSource source(shader.file, defines);
    all_sources += source.text();
    GlObject id(glCreateShader(shader.type), [](GLuint name) { glDeleteShader(name); });
    const char* text = source.text().c_str();
    glShaderSource(id, 1, &text, nullptr);
    glCompileShader(id);
    GLint compiled = 0;
    glGetShaderiv(id, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[10000] = {};
        glGetShaderInfoLog(id, sizeof log, nullptr, log);
        throw std::runtime_error("shader does not compile: " + source.first_error(log));
    }
    return id;
}

}  // namespace

Program::Program(const std::vector<Shader>& shaders, const std::vector<const char*>& varyings,
                 const std::string& defines)
    : id_(glCreateProgram(), [](GLuint name) { glDeleteProgram(name); })
{
    for (const Shader& shader : shaders) {
        glAttachShader(id_, compile(shader, defines, sources_));  // it lives as long as this now
        files_ += (files_.empty() ? "" : " + ") + shader.file;
    }
    if (!varyings.empty()) {
        glTransformFeedbackVaryings(id_, GLsizei(varyings.size()), varyings.data(),
                                    GL_INTERLEAVED_ATTRIBS);
    }
    glLinkProgram(id_);
    GLint linked = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (!linked) {  // so does a varying that no shader writes
        char log[10000] = {};
        glGetProgramInfoLog(id_, sizeof log, nullptr, log);
        throw std::runtime_error("shaders do not link: " + files_ + ": " + first_error_line(log));
    }
    const GLuint block = glGetUniformBlockIndex(id_, "WeatherBlock");
    if (block != GL_INVALID_INDEX) {
        glUniformBlockBinding(id_, block, WEATHER_BLOCK);
        GLint bytes = 0;
        glGetActiveUniformBlockiv(id_, block, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
        if (bytes !=
            GLint(sizeof(snow::Weather))) {  // shaders are read as they are, this was built
            throw std::runtime_error(
                "common/snow.glsl is not the one this program was built with: build again");
        }
    }
}

GLint Program::location(const char* name)
{
    const auto known = locations_.find(name);
    if (known != locations_.end()) return known->second;
    const GLint location = glGetUniformLocation(id_, name);
    if (location < 0 && sources_.find(name) == std::string::npos) {
        std::cerr << files_ << " have no uniform named " << name << std::endl;
    }
    return locations_[name] = location;
}

void Program::set_texture(const char* name, GLuint unit, GLenum target, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target, texture);
    set(name, int(unit));
}
