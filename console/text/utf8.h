#pragma once
// Moving through UTF-8 text by code points. Offsets are bytes. For text that is not valid UTF-8,
// results never exceed the string.

#include <cstddef>
#include <string>
#include <string_view>

#include <fettle/script/cells.h>

namespace fettle::console {

using script::cell_count;
using script::cells_of;
using script::code_point_at;
using script::next_code_point;

inline bool continuation_byte(char c) {
    return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

/// Offset of the code point before `offset`.
std::size_t previous_code_point(std::string_view text, std::size_t offset);
/// The nearest boundary at or before `offset`.
std::size_t code_point_boundary(std::string_view text, std::size_t offset);
std::size_t code_point_count(std::string_view text);
/// Offset of the character in the cell number `index` (from 0), or the length of the text if it has
/// fewer cells.
std::size_t cell_offset(std::string_view text, std::size_t index);
/// Offset of the code point number `index` (from 0), or the length of the text if there are fewer.
std::size_t code_point_offset(std::string_view text, std::size_t index);
void append_code_point(std::string& text, char32_t character);

/// The text as a string literal of Lua.
std::string lua_string(std::string_view text);

/// Converts text for the log: a line end becomes "\n", a tab becomes two spaces, other control
/// characters are removed, and invalid UTF-8 becomes U+FFFD.
std::string clean_text(std::string_view text);

}  // namespace fettle::console
