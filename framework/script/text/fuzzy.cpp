#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>

#include <fettle/property/spelling.h>
#include <fettle/script/fuzzy.h>

namespace fettle::script {

namespace {

using Positions = std::vector<std::size_t>;

constexpr std::size_t longest_name = 256, longest_typed = 64;

char lower_letter(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

/// A name in lower case, without memory of its own: thousands are compared for one key.
class Lower {
  public:
    explicit Lower(std::string_view text) : size_(text.size()) {
        std::ranges::transform(text, letters_.begin(), lower_letter);
    }
    std::string_view text() const { return {letters_.data(), size_}; }

  private:
    std::array<char, longest_name> letters_;
    std::size_t size_;
};

/// The places of the letters that matched, ascending.
struct Places {
    std::array<std::size_t, longest_typed> at;
    std::size_t count = 0;

    void add(std::size_t place) { at[count++] = place; }
    std::size_t last() const { return at[count - 1]; }
};

/// Finds places of the letters where each of them continues a word or begins a later one. `typed`
/// has at most eight letters, the first of which begins the name.
class WordMatch {
  public:
    WordMatch(std::string_view typed, std::string_view name, Places& found)
        : typed_(typed), name_(name), found_(found) {
        found_.add(0);
    }

    /// Finds places for the letters after those that were found. False if there are none.
    bool match_rest() {
        const std::size_t next = found_.count;
        if (next == typed_.size()) return true;
        for (std::size_t at = found_.last() + 1; at < name_.size(); ++at) {
            if (name_[at] != typed_[next] || (at != found_.last() + 1 && name_[at - 1] != '_'))
                continue;
            // The rest did not fit before with this letter at this place, so it does not fit now.
            if (failed_[at] >> next & 1) continue;
            found_.add(at);
            if (match_rest()) return true;
            --found_.count;
            failed_[at] = static_cast<unsigned char>(failed_[at] | 1 << next);
        }
        return false;
    }

  private:
    std::string_view typed_, name_;
    Places& found_;
    std::array<unsigned char, longest_name> failed_{};  // by place; a bit for each letter
};

bool begin_words(std::string_view typed, std::string_view name, Places& found) {
    found.count = 0;
    return typed.size() > 1 && typed.size() <= 8 && typed[0] == name[0] &&
           WordMatch(typed, name, found).match_rest();
}

bool in_order(std::string_view typed, std::string_view name, Places& found) {
    found.count = 0;
    for (const char letter : typed) {
        const std::size_t at = name.find(letter, found.count == 0 ? 0 : found.last() + 1);
        if (at == std::string_view::npos) return false;
        found.add(at);
    }
    return true;
}

struct Match {
    int score = 0;
    std::size_t first = 0, count = 0;  // a run of letters
    bool scattered = false;            // they are in the places instead
};

std::optional<Match> match(std::string_view typed, std::string_view name, Places& places) {
    const auto begins = [&](int score) { return Match{.score = score, .count = typed.size()}; };
    if (typed.empty()) return begins(1);
    if (typed == name) return begins(1000);
    if (typed.size() > longest_typed || name.size() > longest_name) {
        if (name.starts_with(typed)) return begins(800);
        return std::nullopt;
    }
    if (name.empty()) return std::nullopt;
    const int longer = static_cast<int>(
        std::min<std::size_t>(name.size() > typed.size() ? name.size() - typed.size() : 0, 50));
    if (name.starts_with(typed)) return begins(900 - longer);
    const Lower lower_typed(typed), lower_name(name);
    const std::string_view a = lower_typed.text(), b = lower_name.text();
    if (b.starts_with(a)) return begins(800 - longer);
    if (in_order(a, b, places)) {  // else neither words nor a part of the name fit
        const std::size_t spread = places.last() - places.at[0] + 1;
        if (begin_words(a, b, places)) return Match{.score = 700 - longer, .scattered = true};
        if (const std::size_t at = b.find(a); at != std::string_view::npos)
            return Match{.score = 600 - longer, .first = at, .count = a.size()};
        in_order(a, b, places);
        const auto skipped = static_cast<int>(spread - places.count);
        return Match{.score = std::max(100, 500 - 10 * skipped), .scattered = true};
    }
    if (a.size() >= 4 && property::edit_distance(a, b.substr(0, a.size()), 1) <= 1)
        return Match{.score = 50};
    return std::nullopt;
}

}  // namespace

std::optional<int> fuzzy_score(std::string_view typed, std::string_view name) {
    Places places;
    const std::optional<Match> found = match(typed, name, places);
    return found ? std::optional(found->score) : std::nullopt;
}

std::optional<FuzzyMatch> fuzzy_match(std::string_view typed, std::string_view name) {
    Places places;
    const std::optional<Match> found = match(typed, name, places);
    if (!found) return std::nullopt;
    FuzzyMatch result{.score = found->score, .positions = Positions(found->count)};
    std::iota(result.positions.begin(), result.positions.end(), found->first);
    if (found->scattered)
        result.positions.assign(places.at.begin(), places.at.begin() + places.count);
    return result;
}

}  // namespace fettle::script
