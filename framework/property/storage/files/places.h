#pragma once
// Where files about a game lie.

#include <filesystem>
#include <string>
#include <vector>

namespace fettle::property {

/// The folder with main.lua, or with the .lua file.
std::filesystem::path game_folder(const std::filesystem::path& game);
/// "main", or what the .lua file is called.
std::string game_name(const std::filesystem::path& game);
/// Beside the game, then the user's own folder for it.
std::vector<std::filesystem::path> journal_folders(const std::filesystem::path& game);

}  // namespace fettle::property
