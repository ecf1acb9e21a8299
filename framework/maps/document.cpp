#include "document.h"

#include <algorithm>

#include <fettle/property/error.h>
#include <fettle/property/utf8.h>

namespace fettle::maps {

namespace {

/// Greatest number of lists and objects around a value. Groups of layers can contain groups.
constexpr int deepest = 256;

/// The reason in an exception of the JSON library, which begins with "[json...] parse error at ...:
/// ".
std::string reason(const std::string& what) {
    const std::size_t place = what.find(": ");
    return place == std::string::npos ? what : what.substr(place + 2);
}

/// Refuses values inside too many others, which take the library much memory. Not with a callback
/// of the library: at the end of each object, it looks at all members of the list around it.
void limit_depth(const std::string& file, std::string_view text) {
    int depth = 0;
    bool in_text = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_text) {
            if (c == '\\') ++i;
            in_text = c != '"';
        } else if (c == '"') {
            in_text = true;
        } else if (c == '[' || c == '{') {
            if (++depth > deepest)
                fail(file, "nested deeper than " + std::to_string(deepest) + " levels");
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
}

}  // namespace

void fail(const std::string& file, const std::string& message) {
    throw property::Error(property::ErrorKind::damaged, file + ": " + message);
}

std::size_t line_of(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    return 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
}

std::size_t column_of(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const std::size_t line = before.rfind('\n');  // npos + 1 is 0
    return std::max<std::size_t>(property::code_point_count(before.substr(line + 1)), 1);
}

Json parse_document(const std::string& file, std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) fail(file, "the file is empty");
    if (text[first] == '<') return parse_xml(file, text);
    limit_depth(file, text);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        fail(file, "line " + std::to_string(line_of(text, error.byte)) + ", column " +
                       std::to_string(column_of(text, error.byte)) + ": " + reason(error.what()));
    }
}

}  // namespace fettle::maps
