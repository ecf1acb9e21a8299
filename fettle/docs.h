#pragma once
// `fettle docs`: writes the reference and the annotations for editors.

#include <filesystem>
#include <string>
#include <vector>

#include "command.h"

namespace fettle::program {

struct DocsOptions {
    std::filesystem::path folder{};
    std::filesystem::path game{};        // its classes are described too; empty: Fettle's own only
    std::vector<std::string> modules{};  // to be plugged in: files, or names of installed ones
};

Command add_docs(CLI::App& app);

/// Throws FileError for what cannot be written.
int docs(const DocsOptions& options);

}  // namespace fettle::program
