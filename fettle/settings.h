#pragma once
// Reads the settings of a game for commands that have no session of it.

#include <filesystem>
#include <functional>

#include <fettle/property/storage/game_settings.h>

namespace fettle::program {

/// Throws as `property::read_game_settings` does.
property::GameSettings read_settings(const std::filesystem::path& game);

/// Runs a command. The errors of files that it throws are told, and give their exit status.
int with_file_errors(const std::function<int()>& command);

}  // namespace fettle::program
