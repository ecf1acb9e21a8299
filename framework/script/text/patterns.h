#pragma once
// Matches Lua's patterns (reference manual 5.4, section 6.4.1) and counts steps: backtracking can
// take exponential time, and Lua's hooks are not called inside of a C function.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fettle::script {

class PatternMatcher {
  public:
    static constexpr std::size_t max_captures = 32;
    static constexpr std::size_t failed = static_cast<std::size_t>(-1);

    struct Capture {
        std::size_t start = 0;
        std::size_t length = 0;
        enum Kind : std::uint8_t { open, closed, place } kind = open;
    };

    /// `charge(context, steps)` is called after some thousands of steps; it may throw to end the
    /// match.
    PatternMatcher(std::string_view subject, std::string_view pattern,
                   void (*charge)(void* context, std::uint64_t steps), void* context)
        : subject_(subject), pattern_(pattern), charge_(charge), context_(context) {}

    /// End of the match that begins at `start`, or `failed`. Throws std::invalid_argument for a
    /// malformed pattern.
    std::size_t match(std::size_t start, std::size_t pattern_start = 0);

    std::size_t capture_count() const { return count_; }
    const Capture& capture(std::size_t i) const { return captures_[i]; }

  private:
    std::size_t run(std::size_t s, std::size_t p);
    std::size_t item_end(std::size_t p) const;
    bool set_contains(unsigned char c, std::size_t p, std::size_t end) const;
    bool single(std::size_t s, std::size_t p, std::size_t end) const;
    std::size_t longest(std::size_t s, std::size_t p, std::size_t end);
    std::size_t shortest(std::size_t s, std::size_t p, std::size_t end);
    std::size_t balanced(std::size_t s, std::size_t p);
    /// The end of the set at `p` if the frontier of that set is at `s`, otherwise `failed`.
    std::size_t frontier(std::size_t s, std::size_t p);
    std::size_t open_capture(std::size_t s, std::size_t p, Capture::Kind kind);
    std::size_t close_capture(std::size_t s, std::size_t p);
    std::size_t back_reference(std::size_t s, char digit);
    void step(std::uint64_t n = 1);

    std::string_view subject_;
    std::string_view pattern_;
    void (*charge_)(void*, std::uint64_t);
    void* context_;
    std::array<Capture, max_captures> captures_{};
    std::size_t count_ = 0;
    int depth_ = 0;
    std::uint64_t uncharged_ = 0;
};

}  // namespace fettle::script
