#pragma once
// The errors of files that end a command.

#include <functional>

namespace fettle::program {

/// Runs a command. Prints errors of files that it throws, and returns their exit status.
int with_file_errors(const std::function<int()>& command);

}  // namespace fettle::program
