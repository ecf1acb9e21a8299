#pragma once
// The native modules that a game names in modules.json, in a package of it.

#include <filesystem>
#include <vector>

#include <files/archive.h>

namespace fettle::program {

/// Throws FileError if the game has a module that is not installed with Fettle: an archive brings
/// no native code along.
void require_installed_modules(const std::filesystem::path& game);

/// Adds the files of installed modules, and returns the shared libraries that all modules need.
/// Each is opened in another process for that. Throws FileError for a module that is not there,
/// that cannot be opened, or whose file is outside of the game's folder.
std::vector<std::filesystem::path> bring_modules(const std::filesystem::path& game,
                                                 ArchiveFiles& files);

}  // namespace fettle::program
