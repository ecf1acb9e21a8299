#pragma once
// A game as a folder or a Debian package that brings the program and its libraries along.

#include <filesystem>
#include <string>

#include <files/archive.h>

namespace fettle::program {

struct PackageFacts {
    std::string name;     // for players: "Cave Of Lanterns"
    std::string id;       // of files: "cave-of-lanterns"
    std::string version;  // "1.0"
    std::string author;
};

/// Makes a folder, or an archive if the name ends in .tar.gz: `ID/ID` starts the game. Throws
/// FileError.
void make_folder(const std::filesystem::path& to, const PackageFacts& facts,
                 const ArchiveFiles& files);
/// Makes a Debian package, which needs `dpkg-deb`. Throws FileError.
void make_debian_package(const std::filesystem::path& to, const PackageFacts& facts,
                         const ArchiveFiles& files);

}  // namespace fettle::program
