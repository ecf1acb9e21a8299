#include <text/utf8.h>

#include <algorithm>
#include <array>
#include <span>

namespace fettle::console {

std::size_t next_code_point(std::string_view text, std::size_t offset) {
    if (offset >= text.size()) return text.size();
    ++offset;
    while (offset < text.size() && continuation_byte(text[offset])) ++offset;
    return offset;
}

std::size_t previous_code_point(std::string_view text, std::size_t offset) {
    offset = std::min(offset, text.size());
    if (offset == 0) return 0;
    --offset;
    while (offset > 0 && continuation_byte(text[offset])) --offset;
    return offset;
}

std::size_t code_point_boundary(std::string_view text, std::size_t offset) {
    if (offset >= text.size()) return text.size();
    while (offset > 0 && continuation_byte(text[offset])) --offset;
    return offset;
}

std::size_t code_point_count(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continuation_byte(c); }));
}

std::size_t code_point_offset(std::string_view text, std::size_t index) {
    std::size_t offset = 0;
    while (index-- > 0 && offset < text.size()) offset = next_code_point(text, offset);
    return offset;
}

char32_t code_point_at(std::string_view text, std::size_t offset) {
    const auto lead = static_cast<unsigned char>(text[offset]);
    if (lead < 0x80) return lead;
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (next_code_point(text, offset) - offset != length) return 0xfffd;
    char32_t c = lead & (0xffu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i)
        c = c << 6 | (static_cast<unsigned char>(text[offset + i]) & 0x3f);
    return c;
}

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

std::size_t cell_offset(std::string_view text, std::size_t index) {
    std::size_t offset = 0, cells = 0;
    while (offset < text.size()) {
        const std::size_t next = next_code_point(text, offset);
        cells += cell_count(text.substr(offset, next - offset));
        if (cells > index) break;
        offset = next;
    }
    return offset;
}

void append_code_point(std::string& text, char32_t c) {
    if (c > 0x10ffff || (c >= 0xd800 && c < 0xe000)) c = 0xfffd;
    auto put = [&](unsigned byte) { text.push_back(static_cast<char>(byte)); };
    if (c < 0x80) {
        put(c);
    } else if (c < 0x800) {
        put(0xc0 | c >> 6);
        put(0x80 | (c & 0x3f));
    } else if (c < 0x10000) {
        put(0xe0 | c >> 12);
        put(0x80 | (c >> 6 & 0x3f));
        put(0x80 | (c & 0x3f));
    } else {
        put(0xf0 | c >> 18);
        put(0x80 | (c >> 12 & 0x3f));
        put(0x80 | (c >> 6 & 0x3f));
        put(0x80 | (c & 0x3f));
    }
}

namespace {

/// Length of the valid sequence at the start of `text`, 0 if there is none (Unicode 15, table 3-7:
/// no overlong forms, no surrogates, nothing above U+10FFFF).
std::size_t sequence_length(std::string_view text) {
    auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
    unsigned char low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    unsigned char high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    if (byte(1) < low || byte(1) > high) return 0;
    for (std::size_t i = 2; i < length; ++i)
        if (!continuation_byte(text[i])) return 0;
    return length;
}

}  // namespace

std::string lua_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += '\\';
        else if (c == '\n')
            out += "\\";  // before the line break itself
        if (c == '\r')
            out += "\\r";  // a line break for Lua, which would end the text
        else
            out += c;
    }
    return out + '"';
}

std::string clean_text(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        std::size_t length = sequence_length(text.substr(i));
        if (length == 0) {
            append_code_point(out, 0xfffd);
            ++i;
            continue;
        }
        char c = text[i];
        if (length > 1) {
            out.append(text, i, length);
        } else if (c == '\r') {
            if (i + 1 >= text.size() || text[i + 1] != '\n') out.push_back('\n');
        } else if (c == '\t') {
            out += "  ";
        } else if (c == '\n' || static_cast<unsigned char>(c) >= 0x20) {
            if (c != 0x7f) out.push_back(c);
        }
        i += length;
    }
    return out;
}

}  // namespace fettle::console
