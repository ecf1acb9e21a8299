#pragma once
// The subcommand `fettle docs`, which writes the reference and the annotations for editors.

#include <filesystem>
#include <string>
#include <vector>

#include <command_line/command.h>

namespace fettle::program {

struct DocsOptions {
    std::filesystem::path folder{};
    std::filesystem::path game{};        // its classes are described too; empty: only Fettle's own
    std::vector<std::string> modules{};  // modules to plug in: files, or names of installed modules
};

Command add_docs(CLI::App& app);

/// Throws FileError if a file cannot be written.
int docs(const DocsOptions& options);

}  // namespace fettle::program
