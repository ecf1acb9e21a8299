#pragma once
// The subcommands of the `fettle` program; each has a file of its name. They throw FileError and
// the errors of reading the files of a game.

#include <string>

namespace CLI {
class App;
}

namespace fettle::program {

struct Command;

/// Plays a game in a window or headless.
Command add_run(CLI::App& app);
/// Runs the tests of a game without a window.
Command add_test(CLI::App& app);
/// Makes a small game to begin with.
Command add_new_game(CLI::App& app);
/// Prints where the files about a game lie.
Command add_where(CLI::App& app);
/// Makes of a game one file, a folder that runs without an installation of Fettle, or a Debian
/// package.
Command add_package(CLI::App& app);
/// The console in the terminal, of a game without a window or of a game that runs already.
Command add_repl(CLI::App& app);
/// Writes the reference and the annotations for editors.
Command add_docs(CLI::App& app);

/// `fettle repl --attach`: the terminal types into the console of a game that runs already.
/// `wanted`: the game's name, path or process; "": the only one that listens. Returns the exit
/// status.
int attach(const std::string& wanted);

/// Runs the subcommand that the arguments of main() name; returns the exit status.
int run_program(int argc, char** argv);

}  // namespace fettle::program
