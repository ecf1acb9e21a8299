#pragma once
// Reads the settings of a game for commands that have no session of it.

#include <filesystem>

#include <fettle/property/storage/game_settings.h>

namespace fettle::program {

/// Throws as `property::read_game_settings` does.
property::GameSettings read_settings(const std::filesystem::path& game);

}  // namespace fettle::program
