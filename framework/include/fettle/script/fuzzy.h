#pragma once
// Fuzzy matching of typed text with names: one ranking for all completions.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <fettle/script/export.h>

FETTLE_SCRIPT_BEGIN

namespace fettle::script {

struct FuzzyMatch {
    int score = 0;                       ///< higher is better; at most 1000
    std::vector<std::size_t> positions;  ///< bytes of the name that matched, ascending
};

/// How well `typed` fits `name`; nullopt if it does not. From best to worst: the name itself, its
/// beginning, the beginnings of its words ("av": angular_velocity), a part of it, its letters in
/// order, one typing error (without positions). Letter case counts only between equal beginnings.
/// An empty text fits every name.
std::optional<FuzzyMatch> fuzzy_match(std::string_view typed, std::string_view name);
/// Its score alone, which takes no memory.
std::optional<int> fuzzy_score(std::string_view typed, std::string_view name);

}  // namespace fettle::script

FETTLE_SCRIPT_END
