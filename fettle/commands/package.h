#pragma once
// The subcommand `fettle package`: a game as one file, as a folder that runs without an
// installation of Fettle, or as a Debian package.

#include <filesystem>
#include <string>
#include <vector>

#include <command_line/command.h>

namespace fettle::program {

struct PackageOptions {
    std::filesystem::path game{};
    // The files to make; empty: this one is not made.
    std::filesystem::path file{};       // NAME.fettle
    std::filesystem::path linux_run{};  // a folder, or NAME.tar.gz
    std::filesystem::path deb{};        // NAME.deb
    std::vector<std::string> made{};    // names of files that the game itself makes
};

Command add_package(CLI::App& app);

int package(const PackageOptions& options);

}  // namespace fettle::program
