#include "fuzzy.h"
#include "words.h"

#include <algorithm>
#include <cctype>
#include <string>

#include <fettle/property/spelling.h>

namespace fettle::script {

namespace {

// Each letter continues the last word or begins a later one.
bool matches_words(std::string_view typed, std::string_view name, std::size_t i, std::size_t at) {
    if (i == typed.size()) return true;
    if (at < name.size() && name[at] == typed[i] && matches_words(typed, name, i + 1, at + 1))
        return true;
    for (std::size_t n = at + 1; n < name.size(); ++n)
        if (name[n - 1] == '_' && name[n] == typed[i] && matches_words(typed, name, i + 1, n + 1))
            return true;
    return false;
}

// Letters skipped between the first and the last that match, or -1.
int gaps(std::string_view typed, std::string_view name) {
    std::size_t at = 0, first = 0;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        at = name.find(typed[i], at);
        if (at == std::string_view::npos) return -1;
        if (i == 0) first = at;
        ++at;
    }
    return static_cast<int>(at - first - typed.size());
}

}  // namespace

int fuzzy_score(std::string_view typed, std::string_view name) {
    if (typed.empty()) return 1;
    if (typed == name) return 1000;
    if (typed.size() > 64 || name.size() > 256) return name.starts_with(typed) ? 800 : 0;
    const int longer = static_cast<int>(
        std::min<std::size_t>(name.size() > typed.size() ? name.size() - typed.size() : 0, 50));
    if (name.starts_with(typed)) return 900 - longer;
    const std::string a = lower(typed), b = lower(name);
    if (b.starts_with(a)) return 800 - longer;
    if (a.size() > 1 && a.size() <= 8 && a[0] == b[0] && matches_words(a, b, 1, 1))
        return 700 - longer;
    if (b.find(a) != std::string::npos) return 600 - longer;
    if (const int skipped = gaps(a, b); skipped >= 0 && a.size() > 1)
        return std::max(100, 500 - 10 * skipped);
    if (a.size() >= 4) {
        const std::string_view start = std::string_view(b).substr(0, a.size());
        if (property::edit_distance(a, start, 1) <= 1) return 50;
    }
    return 0;
}

}  // namespace fettle::script
