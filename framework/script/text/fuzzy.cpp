#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include <fettle/property/spelling.h>
#include <fettle/script/fuzzy.h>

#include <text/words.h>

namespace fettle::script {

namespace {

using Positions = std::vector<std::size_t>;

constexpr std::size_t longest_name = 256;

/// The positions of `count` bytes from `first` on.
Positions run(std::size_t first, std::size_t count) {
    Positions positions(count);
    std::iota(positions.begin(), positions.end(), first);
    return positions;
}

/// Positions of the letters if each of them continues a word or begins a later one; empty if they
/// do not. `typed` has at most eight letters, the first of which begins the name.
class WordMatch {
  public:
    WordMatch(std::string_view typed, std::string_view name) : typed_(typed), name_(name) {}

    Positions positions() {
        found_ = {0};
        return goes_on() ? std::move(found_) : Positions();
    }

  private:
    /// Whether the letters after those that are found have a place.
    bool goes_on() {
        const std::size_t next = found_.size();
        if (next == typed_.size()) return true;
        for (std::size_t at = found_.back() + 1; at < name_.size(); ++at) {
            if (name_[at] != typed_[next] || (at != found_.back() + 1 && name_[at - 1] != '_'))
                continue;
            // A letter that led nowhere from here leads nowhere again.
            if (in_vain_[at] >> next & 1) continue;
            found_.push_back(at);
            if (goes_on()) return true;
            found_.pop_back();
            in_vain_[at] = static_cast<unsigned char>(in_vain_[at] | 1 << next);
        }
        return false;
    }

    std::string_view typed_, name_;
    Positions found_;
    std::array<unsigned char, longest_name> in_vain_{};  // by place; a bit for each letter
};

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
    if (typed.size() > 64 || name.size() > longest_name) {
        if (name.starts_with(typed)) return begins(800);
        return std::nullopt;
    }
    const int longer = static_cast<int>(
        std::min<std::size_t>(name.size() > typed.size() ? name.size() - typed.size() : 0, 50));
    if (name.starts_with(typed)) return begins(900 - longer);
    const std::string a = lower(typed), b = lower(name);
    if (b.starts_with(a)) return begins(800 - longer);
    if (a.size() > 1 && a.size() <= 8 && a[0] == b[0])
        if (Positions words = WordMatch(a, b).positions(); !words.empty())
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
