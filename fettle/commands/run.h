#pragma once
// The subcommand `fettle run`, which plays a game in a window or headless.

#include <command_line/command.h>
#include <game/run_options.h>

namespace fettle::program {

Command add_run(CLI::App& app);

int run(const RunOptions& options);

}  // namespace fettle::program
