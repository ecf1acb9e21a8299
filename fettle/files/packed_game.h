#pragma once
// The files of a game that belong into a package or a shared moment.

#include <filesystem>
#include <string>
#include <vector>

#include <files/archive.h>

namespace fettle::program {

struct PackedGame {
    ArchiveFiles files{};
    std::vector<std::string> left_out{};  // names of files and of whole folders ("tests/")
    bool one_file = false;                // the game is one .lua file, and nothing beside it
};

/// All files of the game's folder but hidden ones, its tests, sources of art, backups, tweaks,
/// packages (also folders of `fettle package --linux`), and what matches `exclude`, the list in its
/// game.json. Throws FileError, for links that lead out of the folder, too.
PackedGame packed_game(const std::filesystem::path& game, const std::vector<std::string>& exclude);

}  // namespace fettle::program
