// Search for the nearest spelling of a name.

#include <fettle/property/spelling.h>

#include <algorithm>
#include <array>

namespace fettle::property {
namespace {

char lower(char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
}

bool same_but_for_case(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

bool begins(std::string_view name, std::string_view longer) {
    return longer.size() > name.size() && same_but_for_case(name, longer.substr(0, name.size()));
}

/// "frict" begins "friction"; "bounce" is the last word of "out_bounce", and "a" that of "body_a".
/// "x" and "y" are more often meant as parts of a vector than as that of "locked_x".
bool is_part(std::string_view name, std::string_view longer) {
    if (name.empty() || name == "x" || name == "y" || longer.size() <= name.size()) return false;
    const std::size_t more = longer.size() - name.size();
    return (name.size() >= 3 && begins(name, longer)) ||
           (longer[more - 1] == '_' && same_but_for_case(name, longer.substr(more)));
}

/// True for "ball" and "all": a word of three letters is similar to many others. So if the first
/// letters and the lengths differ, these are probably different words.
bool unlike(std::string_view a, std::string_view b) {
    return std::min(a.size(), b.size()) == 3 && a.size() != b.size() && lower(a[0]) != lower(b[0]);
}

}  // namespace

bool contains_ignoring_case(std::string_view text, std::string_view part) {
    const auto same = [](char x, char y) { return lower(x) == lower(y); };
    return part.empty() ||
           std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
    const std::size_t longer = std::max(a.size(), b.size());
    const std::size_t shorter = std::min(a.size(), b.size());
    constexpr std::size_t longest = 256;
    if (longer - shorter > limit || longer > longest) return limit + 1;
    // The common beginning and the common end do not change the distance.
    while (!a.empty() && !b.empty() && lower(a.front()) == lower(b.front())) {
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    while (!a.empty() && !b.empty() && lower(a.back()) == lower(b.back())) {
        a.remove_suffix(1);
        b.remove_suffix(1);
    }
    if (a.empty() || b.empty()) return std::min(a.size() + b.size(), limit + 1);
    std::array<std::array<std::size_t, longest + 1>, 3> rows;
    std::size_t *before = rows[0].data(), *last = rows[1].data(), *row = rows[2].data();
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1]))
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return std::min(last[b.size()], limit + 1);
}

bool of_one_series(std::string_view a, std::string_view b) {
    const std::size_t shorter = std::min(a.size(), b.size());
    std::size_t front = 0, back = 0;
    while (front < shorter && lower(a[front]) == lower(b[front])) ++front;
    while (back < shorter - front && lower(a[a.size() - 1 - back]) == lower(b[b.size() - 1 - back]))
        ++back;
    const std::string_view of_a = a.substr(front, a.size() - front - back);
    const std::string_view of_b = b.substr(front, b.size() - front - back);
    const auto counts = [](std::string_view part) {
        return std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    if (of_a.size() + of_b.size() > 0 && counts(of_a) && counts(of_b)) return true;
    if (back != 0 || front == 0 || of_a.size() != 1 || of_b.size() != 1) return false;
    const auto capital = [](std::string_view part) { return part[0] >= 'A' && part[0] <= 'Z'; };
    return a[front - 1] == '_' || (capital(of_a) && capital(of_b));
}

bool near_miss(std::string_view name, std::string_view declared) {
    if (name == declared) return false;
    if (same_but_for_case(name, declared)) return true;
    return std::min(name.size(), declared.size()) >= 4 && edit_distance(name, declared, 1) <= 1 &&
           !of_one_series(name, declared);
}

bool misspells(std::string_view name, Type given, std::string_view declared, Type type) {
    if (!near_miss(name, declared)) return false;
    const bool plural = name.ends_with('s') && name.substr(0, name.size() - 1) == declared;
    const auto numeric = [](Type of) { return of == Type::number || of == Type::integer; };
    // A text may stand for a color, nil for any value.
    const bool same_kind = given == type || (numeric(given) && numeric(type)) ||
                           given == Type::text || given == Type::nil || type == Type::nil;
    return !plural || same_kind;
}

std::string nearest(std::string_view name, std::span<const std::string> candidates) {
    // A third of the letters may be wrong, but not all: "velosity" is found by its distance,
    // "frict" and "bounce" as parts of names.
    const std::size_t limit = std::max<std::size_t>(1, name.size() / 3);
    std::size_t best_distance = limit + 1;
    const std::string* best = nullptr;
    for (const std::string& candidate : candidates) {
        if (candidate == name) continue;
        std::size_t distance = edit_distance(name, candidate, limit);
        if (distance >= std::max(name.size(), candidate.size())) distance = limit + 1;
        if (unlike(name, candidate)) distance = limit + 1;
        if (distance > limit && is_part(name, candidate)) distance = limit;
        // "rand" is rather "random" than "randomseed".
        const bool closer = best != nullptr && distance == best_distance &&
                            begins(name, candidate) && begins(name, *best) &&
                            candidate.size() < best->size();
        if (distance < best_distance || closer) {
            best_distance = distance;
            best = &candidate;
        }
    }
    return best ? *best : std::string();
}

std::string suggestion(std::string_view name, std::span<const std::string> candidates) {
    const std::string found = nearest(name, candidates);
    return found.empty() ? std::string() : " (did you mean \"" + found + "\"?)";
}

std::string with_article(std::string_view noun) {
    const auto vowel_at = [&](std::size_t at) {
        return at < noun.size() && std::string_view("aeiou").find(lower(noun[at])) != noun.npos;
    };
    // "a Unit" and "a User", but "an Umbrella".
    const bool sounds_like_y =
        !noun.empty() && lower(noun[0]) == 'u' && !vowel_at(1) && vowel_at(2);
    return (vowel_at(0) && !sounds_like_y ? "an " : "a ") + std::string(noun);
}

}  // namespace fettle::property
