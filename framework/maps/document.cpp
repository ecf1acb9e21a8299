#include "document.h"

#include <algorithm>

#include <fettle/property/error.h>

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

}  // namespace

void fail(const std::string& file, const std::string& message) {
    throw property::Error(property::ErrorKind::damaged, file + ": " + message);
}

std::size_t line_of(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    return 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
}

Json parse_document(const std::string& file, std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) fail(file, "the file is empty");
    if (text[first] == '<') return parse_xml(file, text);
    // A value inside thousands of others takes the library much memory.
    const auto limit_depth = [&](int depth, Json::parse_event_t, const Json&) {
        if (depth > deepest)
            fail(file, "nested deeper than " + std::to_string(deepest) + " levels");
        return true;
    };
    try {
        return Json::parse(text, limit_depth);
    } catch (const Json::parse_error& error) {
        fail(file,
             "line " + std::to_string(line_of(text, error.byte)) + ": " + reason(error.what()));
    }
}

}  // namespace fettle::maps
