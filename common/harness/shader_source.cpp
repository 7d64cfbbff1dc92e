#include "common/harness/shader_source.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

#include "common/harness/files.hpp"
#include "common/harness/text.hpp"

namespace {

// How far apart the line numbers are that the compiler is told for one file and for the next. With
// these a line's number alone says which file it is in: Mesa forgets what else #line can tell, the
// number of a file, in what it says of an expression.
constexpr size_t lines_of_a_file = 100000;

// The file that a line includes; empty if it is no #include.
std::string included_by(const std::string& line)
{
    const size_t start = line.find_first_not_of(" \t");
    if (start == std::string::npos || line.compare(start, 8, "#include") != 0) return {};
    const size_t open = line.find('"', start), close = line.find('"', open + 1);
    return close == std::string::npos ? std::string() : line.substr(open + 1, close - open - 1);
}

// Reads a whole number at `place` and moves behind it. False if there is none.
bool read_number(const std::string& text, size_t& place, size_t& number)
{
    const size_t start = place;
    while (place < text.size() && std::isdigit(static_cast<unsigned char>(text[place]))) ++place;
    if (place == start || place - start > 9) return false;
    number = std::stoul(text.substr(start, place - start));
    return true;
}

// Tells the compiler which line of which file comes next.
std::string line_directive(size_t file, int line)
{
    return "#line " + std::to_string(file * lines_of_a_file + size_t(line)) + "\n";
}

bool speaks_of_an_error(const std::string& line)
{
    return lower_case(line).find("error") != std::string::npos;
}

}  // namespace

ShaderSource::ShaderSource(const std::string& file, const std::string& defines)
{
    assemble(file);
    if (!defines.empty()) text_.insert(text_.find('\n') + 1, defines + line_directive(0, 2));
}

void ShaderSource::assemble(const std::string& file)
{
    const size_t number = files_.size();
    files_.push_back(file);
    std::istringstream source(read_file(find_file(file)));
    std::string line;
    for (int count = 1; std::getline(source, line); ++count) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        const std::string included = included_by(line);
        if (included.empty()) {
            text_ += line + "\n";
        } else if (std::find(files_.begin(), files_.end(), included) != files_.end()) {
            text_ += "\n";  // it is in already
        } else {
            text_ += line_directive(files_.size(), 1);
            try {
                assemble(included);
            } catch (
                const std::runtime_error& error) {  // says what is missing; here it is asked for
                throw std::runtime_error(file + ":" + std::to_string(count) + ": " + error.what());
            }
            text_ += line_directive(number, count + 1);
        }
    }
}

// Mesa writes "0:12(5): error: ...", NVIDIA "0(12) : error ...", AMD and Intel "ERROR: 0:12: ...".
std::string ShaderSource::first_error(const std::string& log) const
{
    std::istringstream lines(log);
    std::string line;
    while (std::getline(lines, line)) {
        if (!speaks_of_an_error(line)) continue;
        size_t place = line.rfind("ERROR: ", 0) == 0 ? 7 : 0, string = 0, number = 0;
        if (!read_number(line, place, string)) continue;
        if (line[place] != ':' && line[place] != '(') continue;
        const bool in_parentheses = line[place++] == '(';
        if (!read_number(line, place, number)) continue;
        const size_t file = number / lines_of_a_file;
        if (file >= files_.size()) continue;
        if (in_parentheses) ++place;
        return files_[file] + ":" + std::to_string(number % lines_of_a_file) +
               line.substr(std::min(place, line.size()));
    }
    return files_.front() + ": " + first_error_line(log);
}

std::string first_error_line(const std::string& log)
{
    std::istringstream lines(log);
    std::string line;
    while (std::getline(lines, line)) {
        if (speaks_of_an_error(line)) return line;
    }
    return log.substr(0, log.find('\n'));
}
