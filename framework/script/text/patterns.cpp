#include <cctype>
#include <cstring>
#include <stdexcept>

#include <text/patterns.h>

namespace fettle::script {

namespace {

constexpr int deepest_match = 200;
constexpr std::uint64_t steps_at_once = 4096;
constexpr std::size_t bytes_a_step = 8;         // of a compared text, for one step
constexpr std::size_t bytes_of_set_a_step = 2;  // of a set

bool in_class(unsigned char c, unsigned char name) {
    bool in;
    switch (std::tolower(name)) {
        case 'a':
            in = std::isalpha(c);
            break;
        case 'c':
            in = std::iscntrl(c);
            break;
        case 'd':
            in = std::isdigit(c);
            break;
        case 'g':
            in = std::isgraph(c);
            break;
        case 'l':
            in = std::islower(c);
            break;
        case 'p':
            in = std::ispunct(c);
            break;
        case 's':
            in = std::isspace(c);
            break;
        case 'u':
            in = std::isupper(c);
            break;
        case 'w':
            in = std::isalnum(c);
            break;
        case 'x':
            in = std::isxdigit(c);
            break;
        default:
            return name == c;
    }
    return std::isupper(name) ? !in : in;
}

}  // namespace

void PatternMatcher::step(std::uint64_t n) {
    uncharged_ += n;
    if (uncharged_ < steps_at_once) return;
    charge_(context_, uncharged_);
    uncharged_ = 0;
}

// Index after one pattern item: a character, an escape, or a set in brackets.
std::size_t PatternMatcher::item_end(std::size_t p) const {
    const char first = pattern_[p++];
    if (first == '%') {
        if (p >= pattern_.size()) throw std::invalid_argument("malformed pattern (ends with '%')");
        return p + 1;
    }
    if (first != '[') return p;
    if (p < pattern_.size() && pattern_[p] == '^') ++p;
    do {  // a bracket directly after the beginning is an ordinary character
        if (p >= pattern_.size()) throw std::invalid_argument("malformed pattern (missing ']')");
        if (pattern_[p++] == '%') {
            if (p >= pattern_.size())
                throw std::invalid_argument("malformed pattern (missing ']')");
            ++p;
        }
    } while (p >= pattern_.size() || pattern_[p] != ']');
    return p + 1;
}

// Whether the set between '[' at `p` and ']' at `end - 1` contains the character.
bool PatternMatcher::set_contains(unsigned char c, std::size_t p, std::size_t end) const {
    const std::size_t last = end - 1;
    bool inside = true;
    ++p;
    if (p < last && pattern_[p] == '^') {
        inside = false;
        ++p;
    }
    while (p < last) {
        if (pattern_[p] == '%' && p + 1 < last) {
            if (in_class(c, static_cast<unsigned char>(pattern_[p + 1]))) return inside;
            p += 2;
        } else if (p + 2 < last && pattern_[p + 1] == '-') {
            if (static_cast<unsigned char>(pattern_[p]) <= c &&
                c <= static_cast<unsigned char>(pattern_[p + 2]))
                return inside;
            p += 3;
        } else {
            if (static_cast<unsigned char>(pattern_[p]) == c) return inside;
            ++p;
        }
    }
    return !inside;
}

bool PatternMatcher::single(std::size_t s, std::size_t p, std::size_t end) const {
    if (s >= subject_.size()) return false;
    const auto c = static_cast<unsigned char>(subject_[s]);
    switch (pattern_[p]) {
        case '.':
            return true;
        case '%':
            return in_class(c, static_cast<unsigned char>(pattern_[p + 1]));
        case '[':
            return set_contains(c, p, end);
        default:
            return static_cast<unsigned char>(pattern_[p]) == c;
    }
}

std::size_t PatternMatcher::longest(std::size_t s, std::size_t p, std::size_t end) {
    std::size_t n = 0;
    while (single(s + n, p, end)) {
        ++n;
        step(1 + (end - p) / bytes_of_set_a_step);
    }
    for (;; --n) {
        const std::size_t result = run(s + n, end + 1);
        if (result != failed) return result;
        if (n == 0) return failed;
    }
}

std::size_t PatternMatcher::shortest(std::size_t s, std::size_t p, std::size_t end) {
    for (;; ++s) {
        const std::size_t result = run(s, end + 1);
        if (result != failed) return result;
        if (!single(s, p, end)) return failed;
        step(1 + (end - p) / bytes_of_set_a_step);
    }
}

// Matches %bxy: from x to the y that balances it.
std::size_t PatternMatcher::balanced(std::size_t s, std::size_t p) {
    if (p + 1 >= pattern_.size())
        throw std::invalid_argument("malformed pattern (missing arguments to '%b')");
    if (s >= subject_.size() || subject_[s] != pattern_[p]) return failed;
    const char open = pattern_[p], close = pattern_[p + 1];
    const std::size_t begin = s;
    std::size_t level = 1, found = failed;
    for (++s; s < subject_.size() && found == failed; ++s) {
        if (subject_[s] == close) {
            if (--level == 0) found = s + 1;
        } else if (subject_[s] == open) {
            ++level;
        }
    }
    step(s - begin);  // a failed search is charged too: there may be one for each character
    return found;
}

std::size_t PatternMatcher::open_capture(std::size_t s, std::size_t p, Capture::Kind kind) {
    if (count_ >= max_captures) throw std::invalid_argument("too many captures");
    captures_[count_++] = {s, 0, kind};
    const std::size_t result = run(s, p);
    if (result == failed) --count_;
    return result;
}

std::size_t PatternMatcher::close_capture(std::size_t s, std::size_t p) {
    std::size_t i = count_;
    while (i > 0 && captures_[i - 1].kind != Capture::open) --i;
    if (i == 0) throw std::invalid_argument("invalid pattern capture");
    Capture& capture = captures_[i - 1];
    capture.length = s - capture.start;
    capture.kind = Capture::closed;
    const std::size_t result = run(s, p);
    if (result == failed) capture.kind = Capture::open;
    return result;
}

std::size_t PatternMatcher::back_reference(std::size_t s, char digit) {
    const int i = digit - '1';
    if (i < 0 || static_cast<std::size_t>(i) >= count_ ||
        captures_[static_cast<std::size_t>(i)].kind == Capture::open)
        throw std::invalid_argument("invalid capture index");
    const Capture& capture = captures_[static_cast<std::size_t>(i)];
    const std::size_t length = capture.kind == Capture::closed ? capture.length : 0;
    if (subject_.size() - s < length) return failed;
    step(length / bytes_a_step);
    if (std::memcmp(subject_.data() + capture.start, subject_.data() + s, length) != 0)
        return failed;
    return s + length;
}

std::size_t PatternMatcher::frontier(std::size_t s, std::size_t p) {
    if (p >= pattern_.size() || pattern_[p] != '[')
        throw std::invalid_argument("missing '[' after '%f' in pattern");
    const std::size_t end = item_end(p);
    step(2 * (end - p) / bytes_of_set_a_step);
    const auto before = static_cast<unsigned char>(s == 0 ? '\0' : subject_[s - 1]);
    const auto after = static_cast<unsigned char>(s < subject_.size() ? subject_[s] : '\0');
    return !set_contains(before, p, end) && set_contains(after, p, end) ? end : failed;
}

std::size_t PatternMatcher::match(std::size_t start, std::size_t pattern_start) {
    count_ = 0;
    depth_ = 0;
    const std::size_t end = run(start, pattern_start);
    // A try that fails at once is also charged: there may be one for each character.
    step();
    return end;
}

std::size_t PatternMatcher::run(std::size_t s, std::size_t p) {
    if (++depth_ > deepest_match) throw std::invalid_argument("pattern too complex");
    struct Leave {
        int& depth;
        ~Leave() { --depth; }
    } leave{depth_};
    while (p < pattern_.size()) {
        step();
        const char first = pattern_[p];
        if (first == '(') {
            return p + 1 < pattern_.size() && pattern_[p + 1] == ')'
                       ? open_capture(s, p + 2, Capture::place)
                       : open_capture(s, p + 1, Capture::open);
        }
        if (first == ')') return close_capture(s, p + 1);
        if (first == '$' && p + 1 == pattern_.size()) return s == subject_.size() ? s : failed;
        if (first == '%' && p + 1 < pattern_.size()) {
            const char next = pattern_[p + 1];
            if (next == 'b') {
                s = balanced(s, p + 2);
                if (s == failed) return failed;
                p += 4;
                continue;
            }
            if (next == 'f') {
                p = frontier(s, p + 2);
                if (p == failed) return failed;
                continue;
            }
            if (std::isdigit(static_cast<unsigned char>(next))) {
                s = back_reference(s, next);
                if (s == failed) return failed;
                p += 2;
                continue;
            }
        }
        const std::size_t end = item_end(p);
        step((end - p) / bytes_of_set_a_step);  // a set may be long
        const char suffix = end < pattern_.size() ? pattern_[end] : '\0';
        if (suffix == '*') return longest(s, p, end);
        if (suffix == '+') return single(s, p, end) ? longest(s + 1, p, end) : failed;
        if (suffix == '-') return shortest(s, p, end);
        if (suffix == '?') {
            if (single(s, p, end)) {
                const std::size_t result = run(s + 1, end + 1);
                if (result != failed) return result;
            }
            p = end + 1;
            continue;
        }
        if (!single(s, p, end)) return failed;
        ++s;
        p = end;
    }
    return s;
}

}  // namespace fettle::script
