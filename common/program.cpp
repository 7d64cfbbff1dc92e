#include "common/program.hpp"

#include <algorithm>
#include <iostream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "common/files.hpp"
#include "common/snow.hpp"

namespace {

// The compiler is told that line 12 of the second file is line 200012: whatever the driver writes
// of it, that number says which file it is in.
constexpr size_t lines_of_a_file = 100000;

std::string line_directive(size_t file, size_t line)
{
    return "#line " + std::to_string(file * lines_of_a_file + line);
}

// A shader's text with its includes in place, each file once, and the names of these files.
struct Source {
    std::string text;
    std::vector<std::string> files;

    void append(const std::string& name)
    {
        if (std::find(files.begin(), files.end(), name) != files.end()) return;
        files.push_back(name);
        const size_t file = files.size();
        if (file > 1) text += line_directive(file, 1) + "\n";  // the first line of all is #version
        std::istringstream lines(read_file(find_file(name)));
        std::string line;
        for (size_t number = 1; std::getline(lines, line); ++number) {
            if (line.starts_with("#include \"")) {
                append(line.substr(10, line.rfind('"') - 10));
                line = line_directive(file, number + 1);
            }
            text += line + "\n";
        }
    }

    // The driver's log with each number of a line as the file's name and the line in it. Mesa
    // writes "0:100012(5): error: ...", NVIDIA "0(100012) : error ...", AMD "ERROR: 0:100012: ...".
    std::string translate(std::string log) const
    {
        static const std::regex position(R"(\d+[:(](\d{6,8})\)?)");
        for (std::smatch found; std::regex_search(log, found, position);) {
            const size_t number = std::stoul(found[1]);
            log = found.prefix().str() + files.at(number / lines_of_a_file - 1) + ":" +
                  std::to_string(number % lines_of_a_file) + found.suffix().str();
        }
        return log;
    }
};

GlObject compile(const Shader& shader, const std::string& defines, std::string& all_sources)
{
    Source source;
    source.append(shader.file);
    source.text.insert(source.text.find('\n') + 1, defines + line_directive(1, 2) + "\n");
    all_sources += source.text;
    GlObject id(glCreateShader(shader.type),
                [](GLsizei, const GLuint* name) { glDeleteShader(*name); });
    const char* text = source.text.c_str();
    glShaderSource(id, 1, &text, nullptr);
    glCompileShader(id);
    GLint compiled = 0;
    glGetShaderiv(id, GL_COMPILE_STATUS, &compiled);
    if (compiled) return id;
    char log[10000] = {};
    glGetShaderInfoLog(id, sizeof log, nullptr, log);
    throw std::runtime_error("shader " + shader.file + " does not compile:\n" +
                             source.translate(log));
}

}  // namespace

Program::Program(const std::vector<Shader>& shaders, const std::vector<const char*>& varyings,
                 const std::string& defines)
    : id_(glCreateProgram(), [](GLsizei, const GLuint* name) { glDeleteProgram(*name); })
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
        throw std::runtime_error("shaders " + files_ + " do not link:\n" + log);
    }
    const GLuint block = glGetUniformBlockIndex(id_, "WeatherBlock");
    if (block == GL_INVALID_INDEX) return;
    glUniformBlockBinding(id_, block, WEATHER_BLOCK);
    GLint bytes = 0;
    glGetActiveUniformBlockiv(id_, block, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
    if (bytes != GLint(sizeof(snow::Weather))) {  // shaders are read as they are, this was built
        throw std::runtime_error(
            "common/snow.glsl is not the one this program was built with: build again");
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
