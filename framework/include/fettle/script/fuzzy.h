#pragma once
// Fuzzy matching of what is typed against names: one ranking for everything that completes.

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

/// How well `typed` fits `name`; none: not at all. From best to worst: the name itself, its
/// beginning, the beginnings of its words ("av": angular_velocity), a part of it, letters in order,
/// a slip of one edit (which has no positions). Letter case counts only between equal beginnings.
/// An empty text fits every name.
std::optional<FuzzyMatch> fuzzy_match(std::string_view typed, std::string_view name);

}  // namespace fettle::script

FETTLE_SCRIPT_END
