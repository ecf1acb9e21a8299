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

/// Throws FileError unless `game` is a .lua file, or a folder with
/// main.lua.
void require_game(const std::filesystem::path& game);

/// The folder of a game, itself or where its file is; never empty.
std::filesystem::path folder_of(const std::filesystem::path& game);

/// Whether any Lua file of the game, or one of the chunks, has the word `quit`: whether a headless
/// run can end by itself.
bool mentions_quit(const std::filesystem::path& game, std::span<const std::string> chunks);

}  // namespace fettle::program
