#pragma once
// Regular expressions. A source that uses <regex> takes almost two seconds more to compile; here it
// is compiled once.

#include <string>
#include <vector>

namespace patterns {

/// The text that matches, and behind it its groups; a group that took no part in it is empty.
using Match = std::vector<std::string>;

/// All matches in `text`, from the first to the last.
std::vector<Match> all(const std::string& text, const std::string& pattern);

/// The first match in `text`; empty if there is none.
Match first(const std::string& text, const std::string& pattern);

/// `text` without its matches.
std::string without(const std::string& text, const std::string& pattern);

}  // namespace patterns
