#include "quoting.h"

namespace fettle::property {

namespace {

/// Number of bytes of the control character at `at`: C0, DEL, C1, or a character that changes the
/// direction of text. 0 if there is none.
std::size_t control_character(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
    };
    const unsigned first = byte(0), second = byte(1), third = byte(2);
    if (first < 0x20 || first == 0x7f) return 1;
    if (first == 0xc2 && second >= 0x80 && second <= 0x9f) return 2;  // U+0080 to U+009F
    if (first != 0xe2) return 0;
    const bool embeds = second == 0x80 && third >= 0xaa && third <= 0xae;    // U+202A to U+202E
    const bool isolates = second == 0x81 && third >= 0xa6 && third <= 0xa9;  // U+2066 to U+2069
    return embeds || isolates ? 3 : 0;
}

/// Writes one byte as `\ddd`. There are always three digits, so that a following digit is not read
/// as part of it.
void append_digits(std::string& out, char byte) {
    const unsigned value = static_cast<unsigned char>(byte);
    out += '\\';
    for (const unsigned place : {100u, 10u, 1u}) out += static_cast<char>('0' + value / place % 10);
}

}  // namespace

void append_escaped(std::string& out, std::string_view text, std::size_t& at) {
    if (std::size_t control = control_character(text, at)) {
        for (; control > 0; --control) append_digits(out, text[at++]);
        return;
    }
    if (text[at] == '"' || text[at] == '\\') out += '\\';
    out += text[at++];
}

char unescaped(std::string_view text, std::size_t& at) {
    if (at + 1 >= text.size()) return text[at];
    unsigned value = 0;
    std::size_t end = at + 1;
    while (end < text.size() && end < at + 4 && text[end] >= '0' && text[end] <= '9')
        value = 10 * value + static_cast<unsigned>(text[end++] - '0');
    if (end == at + 1 || value > 255) return text[++at];
    at = end - 1;
    return static_cast<char>(value);
}

}  // namespace fettle::property
