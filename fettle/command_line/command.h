#pragma once
// The type of a subcommand of the program.

#include <functional>

namespace CLI {
class App;
}

namespace fettle::program {

struct Command {
    const CLI::App* app;
    /// Runs the command and returns the exit status.
    std::function<int()> run;
};

}  // namespace fettle::program
