#pragma once
// Texts of the console: code points, cells, literals of Lua, and texts for the log. Offsets are
// bytes.

#include <cstddef>
#include <string>
#include <string_view>

#include <fettle/property/utf8.h>
#include <fettle/script/cells.h>

namespace fettle::console {

using property::append_code_point;
using property::code_point_at;
using property::code_point_boundary;
using property::code_point_count;
using property::code_point_offset;
using property::is_continuation;
using property::next_code_point;
using property::previous_code_point;
using script::cell_count;
using script::cells_of;

/// Offset of the character in the cell number `index` (from 0), or the length of the text if it has
/// fewer cells.
std::size_t cell_offset(std::string_view text, std::size_t index);

/// The text as a string literal of Lua.
std::string lua_string(std::string_view text);

/// Converts text for the log: a line end becomes "\n", a tab becomes two spaces, other control
/// characters are removed, and invalid UTF-8 becomes U+FFFD.
std::string clean_text(std::string_view text);

}  // namespace fettle::console
