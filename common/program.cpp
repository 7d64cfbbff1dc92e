#include "common/program.hpp"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <iostream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "common/files.hpp"

namespace {

constexpr GLuint weather_binding = 0;

// The source with its includes in place, each file once. `files` collects their names: #line tells
// the compiler which one, by its number, a line is from.
std::string assemble(const std::string& name, std::vector<std::string>& files)
{
    const size_t number = files.size();
    files.push_back(name);
    std::istringstream source(read_file(find_file(name)));
    std::string assembled, line;
    static const std::regex include(R"rx(\s*#include\s+"([^"]+)".*)rx");
    for (int count = 1; std::getline(source, line); ++count) {
        std::smatch match;
        if (!std::regex_match(line, match, include)) {
            assembled += line + "\n";
            continue;
        }
        if (std::find(files.begin(), files.end(), match[1]) != files.end()) {
            assembled += "\n";  // it is in already
            continue;
        }
        assembled += "#line 1 " + std::to_string(files.size()) + "\n";
        assembled += assemble(match[1], files);
        assembled += "#line " + std::to_string(count + 1) + " " + std::to_string(number) + "\n";
    }
    return assembled;
}

// The first error of a compiler's log, with the file's name for its number: Mesa writes
// "0:12(5): error: ...", NVIDIA "0(12) : error ...", AMD and Intel "ERROR: 0:12: ...".
std::string first_error(const std::string& log, const std::vector<std::string>& files)
{
    static const std::regex place(R"((?:ERROR: )?(\d+)[:(](\d+)\)?(.*error.*|:.*))");
    std::istringstream lines(log);
    std::string line;
    while (std::getline(lines, line)) {
        std::smatch match;
        if (!std::regex_match(line, match, place)) continue;
        const size_t number = std::stoul(match[1]);
        if (number < files.size()) return files[number] + ":" + match[2].str() + match[3].str();
    }
    return files.front() + ": " + log.substr(0, log.find('\n'));
}

GlObject compile(const Stage& stage, std::string& all_sources)
{
    std::vector<std::string> files;
    const std::string source = assemble(stage.file, files);
    all_sources += source;
    GlObject shader(glCreateShader(stage.type), [](GLuint id) { glDeleteShader(id); });
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        std::string log(10000, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(shader, GLsizei(log.size()), &length, log.data());
        throw std::runtime_error("shader does not compile: " +
                                 first_error(log.substr(0, size_t(length)), files));
    }
    return shader;
}

}  // namespace

Program::Program(const std::vector<Stage>& stages, const std::vector<const char*>& varyings)
    : id_(glCreateProgram(), [](GLuint id) { glDeleteProgram(id); })
{
    for (const Stage& stage : stages) {
        const GlObject shader = compile(stage, sources_);
        glAttachShader(id_, shader);  // from here on it lives as long as the program
        files_ += (files_.empty() ? "" : " + ") + stage.file;
    }
    if (!varyings.empty()) {
        glTransformFeedbackVaryings(id_, GLsizei(varyings.size()), varyings.data(),
                                    GL_INTERLEAVED_ATTRIBS);
    }
    glLinkProgram(id_);
    GLint linked = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (!linked) {  // so does a varying that no shader writes
        std::string log(10000, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(id_, GLsizei(log.size()), &length, log.data());
        log.resize(size_t(length));
        throw std::runtime_error("shaders do not link: " + files_ + ": " +
                                 log.substr(0, log.find('\n')));
    }
    const GLuint block = glGetUniformBlockIndex(id_, "WeatherBlock");
    if (block != GL_INVALID_INDEX) {
        glUniformBlockBinding(id_, block, weather_binding);
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

void Program::set(const char* name, int value)
{
    glUniform1i(location(name), value);
}
void Program::set(const char* name, unsigned value)
{
    glUniform1ui(location(name), value);
}
void Program::set(const char* name, float value)
{
    glUniform1f(location(name), value);
}
void Program::set(const char* name, glm::ivec2 value)
{
    glUniform2iv(location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, glm::vec3 value)
{
    glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::mat4& value)
{
    glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

GlObject upload_weather(const snow::Weather& weather)
{
    GlObject buffer = make_buffer();
    glBindBuffer(GL_UNIFORM_BUFFER, buffer);
    glBufferData(GL_UNIFORM_BUFFER, sizeof weather, &weather, GL_STATIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, weather_binding, buffer);
    return buffer;
}
