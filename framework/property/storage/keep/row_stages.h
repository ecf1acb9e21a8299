#pragma once
// The order in which rows are kept.

#include <vector>

#include <tweaks/journal.h>

namespace fettle::property {

using Rows = std::vector<JournalRow*>;
Rows without_moves(const Rows& rows);
Rows moves_in(const Rows& rows);

/// Deletions come before instances that replace the deleted ones, values after their instances,
/// names last. A deletion below a restored instance comes after the restoration.
enum class Stage { deleted, restored, deleted_below_restored, created, value, moved };
/// `rows`: all rows that are kept together.
Stage stage_of(const JournalRow& row, const Rows& rows);
Rows in_stages(const Rows& rows);

}  // namespace fettle::property
