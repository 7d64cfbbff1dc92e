#include "common/scene/warnings.hpp"

#include <iostream>

void Warnings::add(const std::filesystem::path& file, const Statement& about,
                   const std::string& loss)
{
    for (Warning& warning : warnings_) {
        if (warning.loss != loss) continue;
        ++warning.count;
        return;
    }
    const std::string first =
        file.string() + ": line " + std::to_string(about.line) + ": " + quoted(about.text);
    warnings_.push_back({loss, first, 1});
}

void Warnings::print() const
{
    for (const auto& [loss, first, count] : warnings_) {
        std::cerr << "warning: " << first << ": " << loss;
        if (count > 1) std::cerr << " (and " << count - 1 << " more)";
        std::cerr << std::endl;
    }
}
