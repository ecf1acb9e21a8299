#pragma once
// Code points of texts in UTF-8. Offsets count bytes. For text that is not valid UTF-8, no result
// lies beyond the text.

#include <cstddef>
#include <string>
#include <string_view>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Whether the byte belongs to the code point that an earlier byte begins.
constexpr bool is_continuation(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
}

/// Offset of the code point after the one at `offset`.
std::size_t next_code_point(std::string_view text, std::size_t offset);
/// Offset of the code point before `offset`.
std::size_t previous_code_point(std::string_view text, std::size_t offset);
/// The beginning of the code point with the byte at `offset`; the end of the text for an offset
/// after it.
std::size_t code_point_boundary(std::string_view text, std::size_t offset);
/// Number of code points.
std::size_t code_point_count(std::string_view text);
/// Offset of the code point number `index` (from 0); the end of the text if there are fewer.
std::size_t code_point_offset(std::string_view text, std::size_t index);

/// Number of bytes of the valid code point at the beginning of a text that is not empty; 0 if there
/// is none (Unicode 15, table 3-7: no longer form than needed, no surrogates, nothing above
/// U+10FFFF).
std::size_t valid_code_point_size(std::string_view text);
/// The code point at `offset`, which must be in the text; U+FFFD if it is not valid.
char32_t code_point_at(std::string_view text, std::size_t offset);
/// All code points. Each byte that belongs to no valid one becomes U+FFFD.
std::u32string decode_utf8(std::string_view text);
/// Appends a code point; U+FFFD for a surrogate and for what is above U+10FFFF.
void append_code_point(std::string& text, char32_t code_point);

}  // namespace fettle::property

FETTLE_PROPERTY_END
