// What a scene loses while it is read, and is none the worse for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/scene/statements.hpp"

class Warnings {
public:
    // The statement of the file cost the scene something, `loss`.
    void add(const std::filesystem::path& file, const Statement& about, const std::string& loss);

    // On stderr, each kind of loss in one line.
    void print() const;

private:
    struct Warning {
        std::string loss, first;  // what was lost, and where for the first time
        int count;
    };
    std::vector<Warning> warnings_;
};
