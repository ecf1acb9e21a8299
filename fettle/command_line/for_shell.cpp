#include <command_line/for_shell.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace fettle::program {

std::string for_shell(const std::string& text) {
    const bool plain = !text.empty() && std::ranges::all_of(text, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return std::isalnum(byte) != 0 || byte >= 0x80 ||
               std::string_view("_-./+,:@%=").find(c) != std::string_view::npos;
    });
    if (plain) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

}  // namespace fettle::program
