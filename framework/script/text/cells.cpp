#include <algorithm>
#include <array>
#include <span>

#include <fettle/property/utf8.h>
#include <fettle/script/cells.h>

namespace fettle::script {

using property::code_point_at;
using property::next_code_point;

namespace {

bool within(char32_t c, std::span<const std::array<char32_t, 2>> ranges) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [c](const auto& range) { return c >= range[0] && c <= range[1]; });
}

}  // namespace

// Unicode 15, EastAsianWidth: W and F; of the pictographs beyond U+1F1E5 all, since they are drawn
// as wide as emoji. Not those from U+2600 to U+27BF, which the font of fixed width has.
int cells_of(char32_t c) {
    constexpr std::array<std::array<char32_t, 2>, 4> joining = {
        {{0x200d, 0x200d}, {0xfe00, 0xfe0f}, {0xe0000, 0xe007f}, {0xe0100, 0xe01ef}}};
    constexpr std::array<std::array<char32_t, 2>, 26> wide = {
        {{0x1100, 0x115f},   {0x231a, 0x231b},   {0x23e9, 0x23f3},   {0x2b1b, 0x2b1c},
         {0x2b50, 0x2b55},   {0x2e80, 0x303e},   {0x3041, 0x33ff},   {0x3400, 0x4dbf},
         {0x4e00, 0xa4cf},   {0xa960, 0xa97c},   {0xac00, 0xd7a3},   {0xf900, 0xfaff},
         {0xfe30, 0xfe6f},   {0xff01, 0xff60},   {0xffe0, 0xffe6},   {0x16fe0, 0x18cff},
         {0x1b000, 0x1b2ff}, {0x1f004, 0x1f004}, {0x1f0cf, 0x1f0cf}, {0x1f18e, 0x1f19a},
         {0x1f1e6, 0x1f64f}, {0x1f680, 0x1f6ff}, {0x1f7e0, 0x1f7f0}, {0x1f900, 0x1f9ff},
         {0x1fa70, 0x1faff}, {0x20000, 0x3fffd}}};
    return within(c, joining) ? 0 : within(c, wide) ? 2 : 1;
}

std::size_t cell_count(std::string_view text) {
    std::size_t cells = 0;
    for (std::size_t i = 0; i < text.size(); i = next_code_point(text, i))
        cells += static_cast<unsigned char>(text[i]) < 0xe1
                     ? 1
                     : static_cast<std::size_t>(cells_of(code_point_at(text, i)));
    return cells;
}

}  // namespace fettle::script
