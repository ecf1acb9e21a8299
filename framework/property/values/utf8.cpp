#include <algorithm>

#include <fettle/property/utf8.h>

namespace fettle::property {

std::size_t next_code_point(std::string_view text, std::size_t offset) {
    if (offset >= text.size()) return text.size();
    ++offset;
    while (offset < text.size() && is_continuation(text[offset])) ++offset;
    return offset;
}

std::size_t previous_code_point(std::string_view text, std::size_t offset) {
    offset = std::min(offset, text.size());
    return offset == 0 ? 0 : code_point_boundary(text, offset - 1);
}

std::size_t code_point_boundary(std::string_view text, std::size_t offset) {
    if (offset >= text.size()) return text.size();
    while (offset > 0 && is_continuation(text[offset])) --offset;
    return offset;
}

std::size_t code_point_count(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); }));
}

std::size_t code_point_offset(std::string_view text, std::size_t index) {
    std::size_t offset = 0;
    while (index-- > 0 && offset < text.size()) offset = next_code_point(text, offset);
    return offset;
}

std::size_t valid_code_point_size(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < size) return 0;
    const unsigned char low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const unsigned char high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    if (byte(1) < low || byte(1) > high) return 0;
    for (std::size_t i = 2; i < size; ++i)
        if (!is_continuation(text[i])) return 0;
    return size;
}

namespace {

/// `size`: `valid_code_point_size` of the text.
char32_t first_code_point(std::string_view text, std::size_t size) {
    if (size == 0) return U'\uFFFD';
    const auto lead = static_cast<unsigned char>(text[0]);
    char32_t code_point = size == 1 ? lead : lead & (0xffu >> (size + 1));
    for (std::size_t i = 1; i < size; ++i)
        code_point = code_point << 6 | (static_cast<unsigned char>(text[i]) & 0x3f);
    return code_point;
}

}  // namespace

char32_t code_point_at(std::string_view text, std::size_t offset) {
    text.remove_prefix(offset);
    return first_code_point(text, valid_code_point_size(text));
}

std::u32string decode_utf8(std::string_view text) {
    std::u32string code_points;
    code_points.reserve(text.size());
    while (!text.empty()) {
        const std::size_t size = valid_code_point_size(text);
        code_points.push_back(first_code_point(text, size));
        text.remove_prefix(std::max<std::size_t>(1, size));
    }
    return code_points;
}

void append_code_point(std::string& text, char32_t c) {
    if (c > 0x10ffff || (c >= 0xd800 && c < 0xe000)) c = U'\uFFFD';
    const auto put = [&](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    // The low six bits of `c >> bits`.
    const auto put_continuation = [&](int bits) { put(0x80 | (c >> bits & 0x3f)); };
    if (c < 0x80) {
        put(c);
    } else if (c < 0x800) {
        put(0xc0 | c >> 6), put_continuation(0);
    } else if (c < 0x10000) {
        put(0xe0 | c >> 12), put_continuation(6), put_continuation(0);
    } else {
        put(0xf0 | c >> 18), put_continuation(12), put_continuation(6), put_continuation(0);
    }
}

}  // namespace fettle::property
