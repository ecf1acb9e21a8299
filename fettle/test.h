#pragma once
// The subcommand `fettle test`, which runs the tests of a game without a window.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "command.h"

namespace fettle::program {

struct TestOptions {
    std::filesystem::path game = ".";
    std::string filter{};           // only tests whose file or name contains it
    std::filesystem::path junit{};  // report to write; empty: none
    bool update = false;            // write the pictures instead of comparing them
    std::uint64_t timeout = 60;     // s, of each test
    std::vector<std::string> modules{};
};

Command add_test(CLI::App& app);

/// Runs the tests and prints a report. Throws FileError and others, as `run` does.
int test(const TestOptions& options);

}  // namespace fettle::program
