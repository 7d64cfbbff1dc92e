// Text files as OBJ and MTL have them, taken apart into statements.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/harness/text.hpp"

struct Statement {
    int line;               // where it begins, counted from 1
    std::string_view text;  // all of it; perhaps with a comment behind it
    std::string keyword;    // its first word, in small letters
    std::string_view rest;  // what follows
};

// Hands out the statements of a file one by one; their text lives as long as this does. A statement
// is a line, or several of which each but the last ends in a backslash. Lines may end as on Unix,
// on Windows or on old Macs. Comments, empty lines, and the mark that some editors put in front of
// UTF-8 are passed over.
class Statements {
public:
    // Reads the file, or the pipe, to its end. Throws std::runtime_error naming it if it has no
    // end, as /dev/zero, or is no text.
    explicit Statements(const std::filesystem::path& path);

    // Nothing after the last.
    std::optional<Statement> next();

    // How much of the file has been handed out, 0 to 1.
    double done() const { return double(at_) / double(text_.size()); }

private:
    size_t pass_line();
    bool is_joined(size_t begin, size_t end) const;

    std::string text_;
    size_t at_ = 0;  // where the next line begins
    int line_ = 1;   // its number
};

// `text` without a comment behind it. Not for names: they may have a # in them.
std::string_view without_comment(std::string_view text);

// Takes the first word off `text`, and the blanks around it; an empty one if there is none left.
std::string_view take_word(std::string_view& text);

// The number that `word` is, if it is one that a double can hold.
std::optional<double> to_number(std::string_view word);

// In quotation marks, as it can be shown on one line.
std::string quoted(std::string_view text);
