// Programs of the same shaders, one for each set of parts that are on.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/program.hpp"

class Permutations {
public:
    // As Program's. Compiles the program that has none of the parts, so that a fault is told at
    // once, if it is not in a line of a part.
    explicit Permutations(std::vector<Shader> shaders, std::vector<const char*> varyings = {});

    // The program with these parts, lines `#define NAME`, compiled when it is first asked for. Of
    // what is off it has not a line: an `if` costs, as some drivers compute both sides.
    Program& with(const std::string& parts);

private:
    std::vector<Shader> shaders_;
    std::vector<const char*> varyings_;
    std::map<std::string, Program> programs_;  // by their parts
};

// Puts the program with the parts of this frame to use.
using UseProgram = std::function<Program&(Permutations&)>;
