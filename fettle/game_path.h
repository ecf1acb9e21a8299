#pragma once
// Where games lie.

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>

namespace fettle::program {

/// A file that could not be read or written; the message names it.
class FileError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The showcase, installed beside the program or in the source folder it was built from. Throws
/// FileError when it is in neither.
std::filesystem::path showcase();

/// Fettle's own assets; empty when they are missing.
std::filesystem::path assets();

/// The folder of the modules that are installed with the program.
std::filesystem::path installed_modules();

/// The game that is named: a .lua file, or a folder with main.lua. A link to a file leads to the
/// game that lies there. Throws FileError for what is neither.
std::filesystem::path found_game(const std::filesystem::path& named);

/// Throws FileError when something is there that is no regular file: opening a pipe would wait for
/// whoever is at its other end. `expected`: "a recording".
void require_file(const std::filesystem::path& file, const char* expected);

/// The folder of a game, itself or where its file is; never empty.
std::filesystem::path folder_of(const std::filesystem::path& game);

/// Whether any Lua file of the game, or one of the chunks, has the word `quit`: whether a headless
/// run can end by itself.
bool mentions_quit(const std::filesystem::path& game, std::span<const std::string> chunks);

}  // namespace fettle::program
