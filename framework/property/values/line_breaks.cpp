#include <fettle/property/line_breaks.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace fettle::property {

namespace {

struct Range {
    char32_t first, last;
};

/// Characters with a line break opportunity on both sides, and their punctuation.
constexpr std::array ideographic{
    Range{0x1100, 0x11ff},   // Hangul, parts of syllables
    Range{0x2e80, 0x303f},   // radicals and punctuation
    Range{0x3041, 0x33ff},   // kana, bopomofo, Hangul letters, enclosed characters
    Range{0x3400, 0x4dbf},   // ideographs
    Range{0x4e00, 0x9fff},   // ideographs
    Range{0xa000, 0xa4cf},   // Yi
    Range{0xa960, 0xa97f},   // Hangul, parts of syllables
    Range{0xac00, 0xd7ff},   // Hangul syllables and parts
    Range{0xf900, 0xfaff},   // ideographs
    Range{0xfe30, 0xfe4f},   // forms of punctuation
    Range{0xff01, 0xffef},   // forms of full and half width
    Range{0x20000, 0x3fffd}  // ideographs
};

constexpr std::u32string_view never_first =
    U"!%),.:;?]}¢°»’”‰′″℃–—…‥、。〃々〉》」』】〕〗〙〛〜〞〟〻"
    U"ぁぃぅぇぉっゃゅょゎゕゖ゛゜ゝゞ゠ァィゥェォッャュョヮヵヶ・ーヽヾ"
    U"ㇰㇱㇲㇳㇴㇵㇶㇷㇸㇹㇺㇻㇼㇽㇾㇿ"
    U"！％），．：；？］｝～｠｡｣､･ｧｨｩｪｫｬｭｮｯｰﾞﾟ";
constexpr std::u32string_view never_last = U"$([{£¥«‘“〈《「『【〔〖〘〚〝＄（［｛｟｢￡￥";

constexpr bool among(std::u32string_view all, char32_t c) {
    return all.find(c) != std::u32string_view::npos;
}

bool is_ideographic(char32_t c) {
    return std::ranges::any_of(
        ideographic, [&](const Range& range) { return c >= range.first && c <= range.last; });
}

/// What belongs to the character before it or holds its neighbors together.
bool joins(char32_t c) {
    constexpr std::array ranges{
        Range{0x300, 0x36f},   Range{0x302a, 0x302f}, Range{0x3099, 0x309a},  Range{0x1160, 0x11ff},
        Range{0x20d0, 0x20ff}, Range{0xfe00, 0xfe0f}, Range{0xe0100, 0xe01ef}};
    return std::ranges::any_of(
               ranges, [&](const Range& range) { return c >= range.first && c <= range.last; }) ||
           c == 0x00a0 || c == 0x200d || c == 0x202f || c == 0x2060 || c == 0xfeff;
}

}  // namespace

bool may_divide(char32_t before, char32_t after) {
    if (after < 0x80 && before < 0x80) return false;
    if (before == zero_width_space) return true;
    if (!is_ideographic(before) && !is_ideographic(after)) return false;
    return !joins(before) && !joins(after) && !among(never_last, before) &&
           !among(never_first, after);
}

}  // namespace fettle::property
