#pragma once
// Where a line of text may be divided although there is no space: in Chinese, Japanese and Korean.

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// U+200B marks such a place in any text, and is not seen.
inline constexpr char32_t zero_width_space = U'\u200b';

/// Whether a line may be divided between two code points, neither of which is a space. These are
/// the main rules of Unicode's line breaking (UAX #14) for ideographs, kana and Hangul: before and
/// after each of them, but no line begins with closing punctuation or a small kana, and none ends
/// with an opening bracket.
bool may_divide(char32_t before, char32_t after);

}  // namespace fettle::property

FETTLE_PROPERTY_END
