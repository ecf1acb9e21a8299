#pragma once
// Rows that are kept by path, in the file of kept tweaks.

#include <keep/keep_run.h>

namespace fettle::property {

/// Keeps rows of all kinds but moves.
void keep_by_path(KeepRun& run, const Rows& rows);
/// Keeps moves of instances that the file of kept tweaks makes.
void keep_moves_by_path(KeepRun& run, Rows rows);

}  // namespace fettle::property
