#pragma once
// The files of a game that belong into a package or a shared moment.

#include <filesystem>

#include <files/archive.h>

namespace fettle::program {

/// All files of the game's folder but hidden ones, its tests, tweaks, and packages. Throws
/// FileError, for links that lead out of the folder, too.
ArchiveFiles packed_game(const std::filesystem::path& game);

}  // namespace fettle::program
