#pragma once
// Of many rows the console shows the first ones. A line with the number of the others stands for
// them; a click on it opens them.

#include <cstddef>
#include <string>
#include <vector>

#include <fettle/script/runtime.h>

namespace fettle::script {

/// How many rows are folded at most.
inline constexpr std::size_t max_folded = 1000;
/// How many changes of an edit, or of its undoing, are not folded.
inline constexpr std::size_t shown_changes = 20;

struct Rows {
    std::size_t before = 0;  // lines above the first row
    std::size_t shown = 0;   // rows that are not folded
    std::size_t total = 0;   // rows that there are; those beyond `shown + max_folded` need no line
    const char* what = "rows";  // "instances"
};

/// Moves the lines of all rows but the first `shown` ones to `folded`, and adds the line "… 77 more
/// (107 WHAT)" instead. The rows are the last of the lines.
void fold_rows(std::vector<std::string>& lines, const Rows& rows, FoldedLines& folded);

}  // namespace fettle::script
