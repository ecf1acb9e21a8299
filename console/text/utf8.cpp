#include <text/utf8.h>

#include <algorithm>

namespace fettle::console {

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
