#pragma once
// The subcommand `fettle test`, which runs the tests of a game without a window.

#include <command_line/command.h>
#include <testing/test_run.h>

namespace fettle::program {

Command add_test(CLI::App& app);

/// Runs the tests and prints a report. Throws FileError and others, as `run` does.
int test(const TestOptions& options);

}  // namespace fettle::program
