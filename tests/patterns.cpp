#include "patterns.h"

#include <map>
#include <regex>

namespace patterns {

namespace {

// Many tests look for one pattern in each line of a file.
const std::regex& compiled(const std::string& pattern) {
    thread_local std::map<std::string, std::regex> kept;
    return kept.try_emplace(pattern, pattern).first->second;
}

Match texts(const std::smatch& found) {
    Match match;
    for (const auto& group : found) match.push_back(group.str());
    return match;
}

}  // namespace

std::vector<Match> all(const std::string& text, const std::string& pattern) {
    std::vector<Match> found;
    for (std::sregex_iterator it(text.begin(), text.end(), compiled(pattern)), end; it != end; ++it)
        found.push_back(texts(*it));
    return found;
}

Match first(const std::string& text, const std::string& pattern) {
    std::smatch found;
    return std::regex_search(text, found, compiled(pattern)) ? texts(found) : Match{};
}

std::string without(const std::string& text, const std::string& pattern) {
    return std::regex_replace(text, compiled(pattern), "");
}

}  // namespace patterns
