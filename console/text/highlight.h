#pragma once
// Splits a line into tokens, for coloring commands and output and for finding paths in them.

#include <cstddef>
#include <string_view>
#include <vector>

namespace fettle::console {

enum class Token {
    plain,
    keyword,
    constant,  // true, false, nil, inf
    number,
    string,
    comment,
    path,     // `world.ball.mass`, `print`
    arrow,    // between old and new value
    problem,  // why a formula has no value: from "in error: " to the end of the line
    symbol
};

struct Span {
    std::size_t begin, end;  // bytes
    Token token;
};

/// Whether it is a word of Lua, which is no name.
bool is_keyword(std::string_view word);

/// Tokens of a line of Lua as typed; only blanks lie between them. Accepts any text.
std::vector<Span> highlight_command(std::string_view line);
/// Tokens of a printed line: numbers, quoted strings, paths, arrows, problems; other text is plain.
std::vector<Span> highlight_output(std::string_view line);

/// The probable position of an error in a source line: the name that the message quotes, the last
/// name of a path in it, or a word of it; otherwise the beginning of the line.
Span error_span(std::string_view source, std::string_view message);

}  // namespace fettle::console
