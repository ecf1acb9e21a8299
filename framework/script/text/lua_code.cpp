#include <algorithm>

#include <text/lua_code.h>

namespace fettle::script {

namespace {

/// The end of the long bracket that begins at `at`, such as `]==]`; "" if none begins there.
std::string end_of_long_bracket(std::string_view text, std::size_t at) {
    if (at >= text.size() || text[at] != '[') return {};
    std::size_t i = at + 1;
    while (i < text.size() && text[i] == '=') ++i;
    const bool begins = i < text.size() && text[i] == '[';
    return begins ? "]" + std::string(i - at - 1, '=') + "]" : std::string();
}

}  // namespace

std::string code_of(std::string_view text) {
    std::string code(text);
    const auto blank = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < std::min(to, code.size()); ++i)
            if (code[i] != '\n') code[i] = ' ';
    };
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        const bool comment = text.substr(at).starts_with("--");
        if (const std::string end = end_of_long_bracket(text, comment ? at + 2 : at);
            !end.empty()) {
            const std::size_t close = std::min(text.find(end, at), text.size());
            comment ? blank(at, close + end.size()) : blank(at + end.size(), close);
            at = close + end.size();
        } else if (comment) {
            const std::size_t line_end = std::min(text.find('\n', at), text.size());
            blank(at, line_end);
            at = line_end;
        } else if (c == '"' || c == '\'') {
            std::size_t close = at + 1;
            while (close < text.size() && text[close] != c) close += text[close] == '\\' ? 2 : 1;
            blank(at + 1, close);
            at = close + 1;
        } else {
            ++at;
        }
    }
    return code;
}

}  // namespace fettle::script
