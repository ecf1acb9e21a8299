#include <interaction/words.h>

#include <algorithm>

#include <fettle/property/utf8.h>

namespace fettle::interface {

namespace {

enum class Sort : std::uint8_t { space, letter, sign };

/// Everything outside of ASCII is a letter, except for its spaces and the marks of punctuation.
Sort sort_of(char32_t c) {
    if (c == U' ' || c == U'\t' || c == U'\u00a0' || c == U'\u3000') return Sort::space;
    const bool letter = (c >= U'0' && c <= U'9') || (c >= U'a' && c <= U'z') ||
                        (c >= U'A' && c <= U'Z') || c == U'_' || c >= 0xc0;
    const bool mark = (c >= 0x2010 && c <= 0x206f) || (c >= 0x3001 && c <= 0x3030);
    return letter && !mark ? Sort::letter : Sort::sign;
}

/// A way along a line.
class Walk {
  public:
    Walk(const std::string& text, std::int64_t at)
        : letters_(property::decode_utf8(text)), at_(std::clamp<std::int64_t>(at, 0, size())) {}
    std::int64_t at() const { return at_; }
    bool before(Sort sort) const { return at_ > 0 && of(at_ - 1) == sort; }
    bool after(Sort sort) const { return at_ < size() && of(at_) == sort; }
    void back_over(Sort sort) {
        while (before(sort)) --at_;
    }
    void on_over(Sort sort) {
        while (after(sort)) ++at_;
    }
    /// What is after the place; at the end, what is before it.
    Sort here() const { return size() == 0 ? Sort::space : of(std::min(at_, size() - 1)); }
    Sort last() const { return at_ > 0 ? of(at_ - 1) : Sort::space; }

  private:
    std::int64_t size() const { return static_cast<std::int64_t>(letters_.size()); }
    Sort of(std::int64_t n) const { return sort_of(letters_[static_cast<std::size_t>(n)]); }

    std::u32string letters_;
    std::int64_t at_;
};

}  // namespace

Span word_at(const std::string& text, std::int64_t place) {
    Walk from(text, place), to(text, place);
    const bool ends = to.before(Sort::letter) && !to.after(Sort::letter);
    const Sort sort = ends ? Sort::letter : to.here();
    from.back_over(sort);
    to.on_over(sort);
    return {from.at(), to.at()};
}

std::int64_t word_before(const std::string& text, std::int64_t place) {
    Walk at(text, place);
    at.back_over(Sort::space);
    at.back_over(at.last());
    return at.at();
}

std::int64_t word_after(const std::string& text, std::int64_t place) {
    Walk at(text, place);
    at.on_over(Sort::space);
    at.on_over(at.here());
    return at.at();
}

}  // namespace fettle::interface
