#pragma once
// The text of a map as JSON in the form of the Tiled editor. XML is converted to that form, so that
// there is one reader. Numbers and booleans from XML stay texts.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace fettle::maps {

using Json = nlohmann::json;

/// Throws Error(damaged) with file, line and reason.
Json parse_document(const std::string& file, std::string_view text);
Json parse_xml(const std::string& file, std::string_view text);

[[noreturn]] void fail(const std::string& file, const std::string& message);
/// The number of the line with this byte, from 1.
std::size_t line_of(std::string_view text, std::size_t byte);
/// The column of a byte, in characters, from 1.
std::size_t column_of(std::string_view text, std::size_t byte);

}  // namespace fettle::maps
