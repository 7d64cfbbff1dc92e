#include "common/scene/statements.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace fs = std::filesystem;

namespace {

constexpr std::string_view blanks = " \t\v\f";

std::string read_text(const fs::path& path)
{
    const auto refuse = [&](const std::string& reason) {
        throw std::runtime_error("cannot read " + path.string() + ": " + reason);
    };
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) refuse("no such file");
    if (fs::is_directory(status)) refuse("a folder");
    // A device may never end, and a pipe may be filled forever.
    if (!fs::is_regular_file(status) && !fs::is_fifo(status)) refuse("neither a file nor a pipe");
    constexpr size_t largest = size_t(512) << 20;  // bytes
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse("no permission");
    std::string text;
    std::vector<char> part(1 << 20);
    do {
        file.read(part.data(), std::streamsize(part.size()));
        text.append(part.data(), size_t(file.gcount()));
        if (text.size() > largest) refuse("larger than 512 MiB, or without end");
    } while (file);
    if (file.bad()) refuse("reading failed");
    if (text.find('\0') != std::string::npos) refuse("not plain text (save it as UTF-8)");
    return text;
}

}  // namespace

Statements::Statements(const fs::path& path) : text_(read_text(path))
{
    const std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
}

std::optional<Statement> Statements::next()
{
    while (at_ < text_.size()) {
        const int line = line_;
        const size_t begin = at_;
        size_t begin_of_line = begin, end = pass_line();
        while (is_joined(begin_of_line, end)) {
            const size_t backslash = text_.rfind('\\', end);
            std::fill(&text_[backslash], &text_[at_], ' ');
            begin_of_line = at_;
            end = pass_line();
        }
        std::string_view rest = std::string_view(text_).substr(begin, end - begin);
        const std::string_view keyword = take_word(rest);
        if (keyword.empty() || keyword.front() == '#') continue;
        const auto length = size_t(rest.data() + rest.size() - keyword.data());
        return Statement{line, {keyword.data(), length}, lower_case(keyword), rest};
    }
    return {};
}

// Returns where the line ends, and goes on to the next.
size_t Statements::pass_line()
{
    const size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    at_ = std::min(end + (text_.compare(end, 2, "\r\n") == 0 ? 2 : 1), text_.size());
    ++line_;
    return end;
}

// Does the line go on in the next one? A backslash in a comment does not make it.
bool Statements::is_joined(size_t begin, size_t end) const
{
    const std::string_view line = std::string_view(text_).substr(begin, end - begin);
    const size_t last = line.find_last_not_of(blanks);
    return last != line.npos && line[last] == '\\' && line.find('#') == line.npos;
}

std::string_view without_comment(std::string_view text)
{
    return text.substr(0, text.find('#'));
}

std::string_view take_word(std::string_view& text)
{
    const size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    const size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(std::min(text.find_first_not_of(blanks, end), text.size()));
    text.remove_suffix(text.size() - (text.find_last_not_of(blanks) + 1));
    return word;
}

std::optional<double> to_number(std::string_view word)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    const char* const end = word.data() + word.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value)) return {};
    return value;
}

std::string quoted(std::string_view text)
{
    constexpr size_t longest = 60;
    std::string shown(text.substr(0, longest));
    const auto is_control = [](unsigned char c) { return c < 32 || c == 127; };
    std::replace_if(shown.begin(), shown.end(), is_control, '?');
    return "'" + shown + (text.size() > longest ? "...'" : "'");
}
