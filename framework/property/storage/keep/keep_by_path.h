#pragma once
// Rows that are kept by path, in the file of kept tweaks.

#include <keep/keep_run.h>

namespace fettle::property {

/// Keeps rows of all kinds but moves.
void keep_by_path(KeepRun& run, const Rows& rows);
/// Keeps moves of instances that the file of kept tweaks makes.
/// The path of the new instance that is the new parent of the row, or above it, and in no file yet;
/// "": there is none.
std::string unkept_parent(const KeepRun& run, const JournalRow& row);
void keep_moves_by_path(KeepRun& run, Rows rows);

}  // namespace fettle::property
