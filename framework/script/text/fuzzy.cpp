#include <algorithm>
#include <numeric>
#include <string>

#include <fettle/property/spelling.h>
#include <fettle/script/fuzzy.h>

#include <text/words.h>

namespace fettle::script {

namespace {

using Positions = std::vector<std::size_t>;

/// The positions of `count` bytes from `first` on.
Positions run(std::size_t first, std::size_t count) {
    Positions positions(count);
    std::iota(positions.begin(), positions.end(), first);
    return positions;
}

/// Whether each remaining letter continues the current word or begins a later one. `found`:
/// positions of the letters so far.
bool matches_words(std::string_view typed, std::string_view name, Positions& found) {
    if (found.size() == typed.size()) return true;
    const char wanted = typed[found.size()];
    for (std::size_t at = found.back() + 1; at < name.size(); ++at) {
        if (name[at] != wanted || (at != found.back() + 1 && name[at - 1] != '_')) continue;
        found.push_back(at);
        if (matches_words(typed, name, found)) return true;
        found.pop_back();
    }
    return false;
}

/// Positions of the letters in order; empty if one is missing.
Positions in_order(std::string_view typed, std::string_view name) {
    Positions found;
    for (const char letter : typed) {
        const std::size_t at = name.find(letter, found.empty() ? 0 : found.back() + 1);
        if (at == std::string_view::npos) return {};
        found.push_back(at);
    }
    return found;
}

}  // namespace

std::optional<FuzzyMatch> fuzzy_match(std::string_view typed, std::string_view name) {
    const auto begins = [&](int score) { return FuzzyMatch{score, run(0, typed.size())}; };
    if (typed.empty()) return begins(1);
    if (typed == name) return begins(1000);
    if (typed.size() > 64 || name.size() > 256) {
        if (name.starts_with(typed)) return begins(800);
        return std::nullopt;
    }
    const int longer = static_cast<int>(
        std::min<std::size_t>(name.size() > typed.size() ? name.size() - typed.size() : 0, 50));
    if (name.starts_with(typed)) return begins(900 - longer);
    const std::string a = lower(typed), b = lower(name);
    if (b.starts_with(a)) return begins(800 - longer);
    if (Positions words = {0};
        a.size() > 1 && a.size() <= 8 && a[0] == b[0] && matches_words(a, b, words))
        return FuzzyMatch{700 - longer, std::move(words)};
    if (const std::size_t at = b.find(a); at != std::string::npos)
        return FuzzyMatch{600 - longer, run(at, a.size())};
    if (Positions found = in_order(a, b); found.size() > 1) {
        const auto skipped = static_cast<int>(found.back() - found.front() + 1 - found.size());
        return FuzzyMatch{std::max(100, 500 - 10 * skipped), std::move(found)};
    }
    if (a.size() >= 4 &&
        property::edit_distance(a, std::string_view(b).substr(0, a.size()), 1) <= 1)
        return FuzzyMatch{50, {}};
    return std::nullopt;
}

}  // namespace fettle::script
