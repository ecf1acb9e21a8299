#pragma once
// The `fettle` program. Each subcommand has its own file.

namespace fettle::program {

/// Runs the subcommand that the arguments of main() name; returns the exit status.
int run_program(int argc, char** argv);

}  // namespace fettle::program
