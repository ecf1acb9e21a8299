#pragma once
// In which order rows are kept.

#include <vector>

#include <tweaks/journal.h>

namespace fettle::property {

using Rows = std::vector<JournalRow*>;
Rows without_moves(const Rows& rows);
Rows moves_in(const Rows& rows);

/// What takes the place of something comes after that has gone, values when their instances are
/// there, names last. What is deleted below something that is back goes when that is there.
enum class Stage { gone, back, gone_below_it, created, value, moved };
/// Of one of the rows.
Stage stage_of(const JournalRow& row, const Rows& rows);
Rows in_stages(const Rows& rows);

}  // namespace fettle::property
