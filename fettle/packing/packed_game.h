#pragma once
// The files of a game that belong into a package, and what would be missing there.

#include <filesystem>
#include <string>
#include <vector>

#include <files/archive.h>

namespace fettle::program {

/// All files of the game's folder but hidden ones, its tests, tweaks, and packages. Throws
/// FileError, for links that lead out of the folder, too.
ArchiveFiles packed_game(const std::filesystem::path& game);

/// Why the game would not run elsewhere, one line each: files that its texts name and that it does
/// not have, that are called differently, or that are named by an absolute path. `made`: names of
/// files that the game makes.
std::vector<std::string> problems_of(const ArchiveFiles& files,
                                     const std::vector<std::string>& made);

}  // namespace fettle::program
