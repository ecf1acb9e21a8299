#pragma once
// Words in a line of text, for double clicks and for arrow keys with ctrl. All places count
// characters, as that of a caret does.

#include <cstdint>
#include <string>

namespace fettle::interface {

/// The characters from `from` up to `to`, without the latter.
struct Span {
    std::int64_t from = 0, to = 0;
    bool empty() const { return from == to; }
    friend bool operator==(const Span&, const Span&) = default;
};

/// The word, or the run of other characters, at a place; the word before it where it ends.
Span word_at(const std::string& text, std::int64_t place);
/// Where the word begins that is before the place, or around it.
std::int64_t word_before(const std::string& text, std::int64_t place);
/// Where the word ends that is after the place, or around it.
std::int64_t word_after(const std::string& text, std::int64_t place);

}  // namespace fettle::interface
