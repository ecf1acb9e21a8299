#pragma once
// Folders and names of a game, and of the files that Fettle keeps for it.

#include <filesystem>
#include <string>
#include <vector>

namespace fettle::property {

/// The folder with main.lua, or with the .lua file.
std::filesystem::path game_folder(const std::filesystem::path& game);
/// "main", or the name of the .lua file without its ending.
std::string game_name(const std::filesystem::path& game);
/// The user's folder for the data of Fettle; empty if the user has none.
std::filesystem::path fettle_data();
/// The folders that may hold the journal, the preferred one first: `.fettle` in the game's folder,
/// then the user's folder for the game.
std::vector<std::filesystem::path> journal_folders(const std::filesystem::path& game);

}  // namespace fettle::property
