#pragma once
// What the parts of a line are: for coloring commands and output, and for finding the paths in
// them.

#include <cstddef>
#include <string_view>
#include <vector>

namespace fettle::console {

enum class Token {
    plain,
    keyword,
    constant,  // true, false, nil
    number,
    string,
    comment,
    path,   // `world.ball.mass`, `print`
    arrow,  // between old and new value
    symbol
};

struct Span {
    std::size_t begin, end;  // bytes
    Token token;
};

/// A line of Lua as typed: spans without gaps except blanks. Tolerates anything.
std::vector<Span> highlight_command(std::string_view line);
/// A printed line: numbers, quoted strings, paths, arrows; prose stays plain.
std::vector<Span> highlight_output(std::string_view line);

/// Where the trouble is in a source line, as far as the message tells: the name it quotes, the last
/// name of the path it complains about, or a word of it; else where the line begins.
Span error_span(std::string_view source_line, std::string_view message);

}  // namespace fettle::console
