#include <algorithm>
#include <cctype>

#include <fettle/property/error.h>
#include <fettle/property/utf8.h>

namespace fettle::property {
namespace {

constexpr std::size_t longest_quoted = 300, kept = 200;  // bytes of a quoted text, or of a word

/// The end of the quoted text or of the word that begins at `at`.
std::size_t end_of_part(std::string_view text, std::size_t at) {
    const std::size_t close = text[at] == '"' ? text.find('"', at + 1) : std::string_view::npos;
    if (close != std::string_view::npos) return close + 1;
    return std::min(text.find_first_of(" \n\"", at + 1), text.size());
}

void append(std::string& out, std::string_view part) {
    const std::size_t end =
        part.size() > longest_quoted ? code_point_boundary(part, kept) : part.size();
    for (const char c : part.substr(0, end)) c == '\0' ? out += "\\0" : out += c;
    if (end == part.size()) return;
    out += "…";
    // A closing quote, or the colon between a path and what is said about it.
    if (std::ispunct(static_cast<unsigned char>(part.back())) != 0) out += part.back();
}

}  // namespace

std::string message_text(std::string_view message) {
    if (message.size() <= longest_quoted && message.find('\0') == std::string_view::npos)
        return std::string(message);
    std::string out;
    for (std::size_t at = 0; at < message.size();) {
        const bool blank = message[at] == ' ' || message[at] == '\n';
        const std::size_t end = blank ? at + 1 : end_of_part(message, at);
        append(out, message.substr(at, end - at));
        at = end;
    }
    return out;
}

}  // namespace fettle::property
