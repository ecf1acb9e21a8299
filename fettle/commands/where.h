#pragma once
// The subcommand `fettle where`, which prints where the files about a game lie.

#include <filesystem>

#include <command_line/command.h>

namespace fettle::program {

Command add_where(CLI::App& app);

/// Prints one line for each place. Throws the errors of reading the settings of the game.
int where(const std::filesystem::path& game);

}  // namespace fettle::program
