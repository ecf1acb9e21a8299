#pragma once
// The locations of games, of Fettle's own files and of installed modules.

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>

namespace fettle::program {

/// A file could not be read or written; the message contains its name.
class FileError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The gallery, a game installed beside the program or in the source folder. Throws FileError if it
/// is in neither.
std::filesystem::path gallery();

/// Fettle's own assets; empty when they are missing.
std::filesystem::path assets();

/// The first page of the guide; empty when it is missing.
std::filesystem::path guide();

/// The folder of the modules that are installed with the program.
std::filesystem::path installed_modules();

/// The path of the game `named`: a .lua file, or a folder with main.lua. A symbolic link to a file
/// is resolved, so the game's folder is that of its target. Throws FileError for other paths.
std::filesystem::path found_game(const std::filesystem::path& named);

/// Throws FileError if `file` exists and is not a regular file: opening a pipe would block until
/// another process opens its other end. `expected` is for the message: "a recording".
void require_file(const std::filesystem::path& file, const char* expected);

/// Writes a file whose folder exists. Throws FileError.
void write_file(const std::filesystem::path& file, const std::string& content);

/// The folder of a game: the path itself, or the folder of its file; never empty.
std::filesystem::path folder_of(const std::filesystem::path& game);

/// Whether a Lua file of the game or one of the chunks contains the word `quit`. Without it, a
/// headless run cannot end by itself.
bool mentions_quit(const std::filesystem::path& game, std::span<const std::string> chunks);

}  // namespace fettle::program
