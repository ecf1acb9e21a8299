#pragma once
// The subcommand `fettle new`, which makes a small game to begin with.

#include <filesystem>
#include <string>

#include <command_line/command.h>

namespace fettle::program {

struct NewGameOptions {
    std::filesystem::path folder{};
    std::string pattern = "empty";  // the name of a folder in assets/templates
};

Command add_new_game(CLI::App& app);

/// Makes the folder with the files of the template and annotations for editors. Throws FileError:
/// for a folder that is there and not empty, an unknown template, or a file that cannot be written;
/// then nothing is made.
int new_game(const NewGameOptions& options);

}  // namespace fettle::program
