#pragma once
// Fuzzy matching of what is typed against names.

#include <string_view>

namespace fettle::script {

/// How well `typed` fits `name`: 0 not at all, more is better. From best to worst: the name itself,
/// its beginning, the beginnings of its words ("av": angular_velocity), a part of it, letters in
/// order, a slip of one edit.
int fuzzy_score(std::string_view typed, std::string_view name);

}  // namespace fettle::script
