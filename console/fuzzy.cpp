#include "fuzzy.h"

#include <algorithm>
#include <limits>

namespace fettle::console {

namespace {

constexpr int unreachable = std::numeric_limits<int>::min() / 2;
// What a letter of the pattern is worth where it is found.
constexpr int any_letter = 1, after_last = 9, word_start = 8, name_start = 10, exact_case = 1;
constexpr std::size_t longest = 256;

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool alphanumeric(char c) {
    return (c >= '0' && c <= '9') || (lower(c) >= 'a' && lower(c) <= 'z');
}

int worth(std::string_view candidate, std::size_t at, char typed) {
    int value = any_letter + (candidate[at] == typed ? exact_case : 0);
    if (at == 0) return value + name_start;
    char before = candidate[at - 1];
    bool camel = before >= 'a' && before <= 'z' && candidate[at] >= 'A' && candidate[at] <= 'Z';
    return value + (!alphanumeric(before) || camel ? word_start : 0);
}

}  // namespace

// best[i][j]: the best score with pattern[i] matched at candidate[j]. A match that follows its
// predecessor directly earns `after_last`; any other looks back at the best of all earlier columns.
std::optional<FuzzyMatch> fuzzy_match(std::string_view pattern, std::string_view candidate) {
    if (pattern.empty()) return FuzzyMatch{};
    candidate = candidate.substr(0, longest);
    std::size_t n = pattern.size(), m = candidate.size();
    if (n > m) return std::nullopt;
    std::vector<int> best(n * m, unreachable);
    std::vector<std::size_t> from(n * m, 0);
    for (std::size_t i = 0; i < n; ++i) {
        int reach = i == 0 ? 0 : unreachable;  // best of row i - 1 before column j
        std::size_t reach_from = 0;
        for (std::size_t j = i; j < m; ++j) {
            if (i > 0 && j > 0 && best[(i - 1) * m + j - 1] > reach) {
                reach = best[(i - 1) * m + j - 1];
                reach_from = j - 1;
            }
            if (lower(pattern[i]) != lower(candidate[j]) || reach == unreachable) continue;
            int score = reach;
            std::size_t predecessor = reach_from;
            if (i > 0 && best[(i - 1) * m + j - 1] + after_last > score) {
                score = best[(i - 1) * m + j - 1] + after_last;
                predecessor = j - 1;
            }
            best[i * m + j] = score + worth(candidate, j, pattern[i]);
            from[i * m + j] = predecessor;
        }
    }
    auto last = best.begin() + static_cast<std::ptrdiff_t>((n - 1) * m);
    auto top = std::max_element(last, best.end());
    if (*top <= unreachable) return std::nullopt;
    FuzzyMatch match;
    // Of equal matches the shorter candidate is the likelier one.
    match.score = *top * 4 - static_cast<int>(m - n);
    match.positions.resize(n);
    auto at = static_cast<std::size_t>(top - last);
    for (std::size_t i = n; i-- > 0;) {
        match.positions[i] = at;
        at = from[i * m + at];
    }
    return match;
}

}  // namespace fettle::console
