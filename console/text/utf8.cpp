#include <text/utf8.h>

namespace fettle::console {

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
        const std::size_t length = property::valid_code_point_size(text.substr(i));
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
