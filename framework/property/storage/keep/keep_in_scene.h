#pragma once
// Rows that are kept in a scene file.

#include <filesystem>

#include <keep/keep_run.h>

namespace fettle::property {

/// Keeps the rows in the file, and makes the changes that follow in other files and rows.
void keep_in_scene(KeepRun& run, const std::filesystem::path& file, const Rows& rows);

}  // namespace fettle::property
