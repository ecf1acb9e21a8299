#pragma once
// Functions for letters, words and blanks.

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace fettle::script {

/// Whether a name may contain the character: a letter, a digit or an underscore.
inline bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The text in lower case.
inline std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

inline bool among(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether the word is one of `words`, which blanks separate.
inline bool holds_word(std::string_view words, std::string_view word) {
    for (std::size_t at = 0; at <= words.size();) {
        const std::size_t end = std::min(words.find(' ', at), words.size());
        if (words.substr(at, end - at) == word) return true;
        at = end + 1;
    }
    return false;
}

/// Whether the word is a word of Lua, as `do` and `then`.
inline bool is_word_of_lua(std::string_view word) {
    return holds_word(
        "and break do else elseif end false for function goto if in local nil not or repeat return "
        "then true until while",
        word);
}

/// The first place from `from` on at which `word` is no part of a longer word; npos if there is
/// none.
inline std::size_t find_word(std::string_view text, std::string_view word, std::size_t from = 0) {
    if (word.empty()) return std::string_view::npos;
    for (std::size_t at = text.find(word, from); at != std::string_view::npos;
         at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool starts = at == 0 || !is_word(text[at - 1]) || !is_word(word.front());
        const bool ends = end == text.size() || !is_word(text[end]) || !is_word(word.back());
        if (starts && ends) return at;
    }
    return std::string_view::npos;
}

/// The text without blanks at both ends.
inline std::string_view trimmed(std::string_view text) {
    const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

/// The text on one line: each run of white space becomes one space; none at the ends.
inline std::string one_line(std::string_view text) {
    std::string out;
    for (const char c : trimmed(text)) {
        const bool space = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!space || out.back() != ' ') out += space ? ' ' : c;
    }
    return out;
}

/// The hint at the end of a message: " (write here)"; "" if there is nothing to write.
inline std::string hint_to_write(std::string_view here) {
    return here.empty() ? std::string() : " (write " + std::string(here) + ")";
}

}  // namespace fettle::script
