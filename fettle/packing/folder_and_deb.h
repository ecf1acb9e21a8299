#pragma once
// A game as a folder or a Debian package that brings the program and its libraries along.

#include <filesystem>
#include <string>
#include <vector>

#include <files/archive.h>

namespace fettle::program {

struct PackageFacts {
    std::string name;        // for players: "Cave Of Lanterns"
    std::string id;          // of files: "cave-of-lanterns"
    std::string version;     // "1.0"
    std::string maintainer;  // "Ada <ada@example.org>"
    std::string icon;        // a file of the game: "art/icon.png"; "" if it has none
};

/// The name of the file that starts the game in the folder: the id, unless a folder in it has that
/// name.
std::string start_of_folder(const PackageFacts& facts);

/// Makes a folder, or an archive if the name ends in .tar.gz: `ID/ID` starts the game
/// (`start_of_folder`). `libraries`: those that the game's modules need, in addition to those of
/// this program. Throws FileError.
void make_folder(const std::filesystem::path& to, const PackageFacts& facts,
                 const ArchiveFiles& files, const std::vector<std::filesystem::path>& libraries);
/// Makes a Debian package, which needs `dpkg-deb`. Throws FileError.
void make_debian_package(const std::filesystem::path& to, const PackageFacts& facts,
                         const ArchiveFiles& files,
                         const std::vector<std::filesystem::path>& libraries);

}  // namespace fettle::program
