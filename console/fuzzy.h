#pragma once
// Fuzzy matching: the letters of what was typed, in order, anywhere in the candidate.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace fettle::console {

struct FuzzyMatch {
    int score = 0;                       // higher is better
    std::vector<std::size_t> positions;  // bytes of the candidate that matched
};

/// Letter case is ignored. Runs of neighbouring letters and starts of words (`grav_sc` in
/// `gravity_scale`) count more, so that the obvious candidate comes first. Empty when a letter is
/// missing. An empty pattern matches everything with score 0.
std::optional<FuzzyMatch> fuzzy_match(std::string_view pattern, std::string_view candidate);

}  // namespace fettle::console
