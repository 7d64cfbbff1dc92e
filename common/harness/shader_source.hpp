// The text of a shader, with its includes in place, and what a compiler has to say about it.
#pragma once

#include <string>
#include <vector>

class ShaderSource {
public:
    // Reads `file`, relative to the source tree, and what it includes: each file once, where a line
    // `#include "folder/file"` first asks for it. `defines` are lines to stand below the first,
    // which tells the version. Throws std::runtime_error.
    explicit ShaderSource(const std::string& file, const std::string& defines = {});

    const std::string& text() const { return text_; }

    // The first error of a compiler's log, with the file's name and the line in it.
    std::string first_error(const std::string& log) const;

private:
    void assemble(const std::string& file);

    std::string text_;
    std::vector<std::string> files_;  // by the number under which #line knows them
};

// The first line of a log that speaks of an error; the first of all if none does.
std::string first_error_line(const std::string& log);
