#pragma once
// The subcommand `fettle repl`: the console of a game that runs without a window, in the terminal.

#include <filesystem>

#include <command_line/command.h>

namespace fettle::program {

Command add_repl(CLI::App& app);

}  // namespace fettle::program
