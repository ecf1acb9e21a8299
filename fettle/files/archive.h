#pragma once
// Games in one file: a ZIP archive, NAME.fettle. Its files are read into memory when the game
// begins.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace fettle::property {
class GameFiles;
}

namespace fettle::program {

/// Content by name; names have forward slashes.
using ArchiveFiles = std::map<std::string, std::string>;

constexpr std::string_view archive_ending = ".fettle";

/// Whether the path is an archive of a game.
bool is_archive(const std::filesystem::path& file);
/// The archive that contains the game file `game` ("cave.fettle/main.lua"); "" if none does.
std::filesystem::path archive_of(const std::filesystem::path& game);

/// Reads all files, or only the one with the name `only`. Throws FileError for a file that is
/// damaged, has names that lead out of a folder, or is too large.
ArchiveFiles read_archive(const std::filesystem::path& file, const std::string& only = {});
/// Writes the whole archive or nothing. Equal files give an equal archive. Throws FileError.
void write_archive(const std::filesystem::path& file, const ArchiveFiles& files);

/// If the game is in an archive, puts its files into `files`, which then writes none to the disk.
void mount_archive(const std::filesystem::path& game, property::GameFiles& files);

}  // namespace fettle::program
