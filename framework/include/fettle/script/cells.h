#pragma once
// How many cells of a font of fixed width a text takes: that of a terminal and of the console.

#include <cstddef>
#include <string_view>

#include <fettle/script/export.h>

FETTLE_SCRIPT_BEGIN

namespace fettle::script {

/// Offset in bytes of the code point after the one at `offset`. For text that is not valid UTF-8,
/// it does not exceed the text.
std::size_t next_code_point(std::string_view text, std::size_t offset);
/// The code point at `offset`; U+FFFD for a sequence that is not complete.
char32_t code_point_at(std::string_view text, std::size_t offset);
/// How many cells a character takes: two for Chinese characters and emoji, zero for a character
/// that only joins or changes its neighbors.
int cells_of(char32_t character);
/// How many cells a text takes.
std::size_t cell_count(std::string_view text);

}  // namespace fettle::script

FETTLE_SCRIPT_END
