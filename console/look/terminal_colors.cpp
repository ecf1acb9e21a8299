#include <fettle/console/terminal_colors.h>

#include <cstdio>

#include <look/theme.h>

namespace fettle::console {
namespace {

constexpr const char* plain = "\x1b[39m";

void add(std::string& out, ImU32 color, std::string_view text) {
    char begin[32];
    std::snprintf(begin, sizeof begin, "\x1b[38;2;%u;%u;%um",
                  static_cast<unsigned>(color >> IM_COL32_R_SHIFT & 255),
                  static_cast<unsigned>(color >> IM_COL32_G_SHIFT & 255),
                  static_cast<unsigned>(color >> IM_COL32_B_SHIFT & 255));
    out += begin;
    out += text;
    out += plain;
}

}  // namespace

std::string colored_output(std::string_view line) {
    std::string out;
    std::size_t done = 0;
    for (const Span& span : highlight_output(line)) {
        if (span.token == Token::plain) continue;  // in the color of the terminal
        out += line.substr(done, span.begin - done);
        add(out, token_color(span.token), line.substr(span.begin, span.end - span.begin));
        done = span.end;
    }
    out += line.substr(done);
    return out;
}

std::string colored_error(std::string_view line) {
    std::string out;
    add(out, palette::error, line);
    return out;
}

}  // namespace fettle::console
